// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QDialog>

class QLabel;
class QListWidget;

namespace romanesco {

/// The examples in pictures; Enter and double clicks open one, and what it shows is said below. The pictures lie in the
/// resources, made by packaging/thumbnails.
class ExampleGallery : public QDialog
{
    Q_OBJECT
public:
    explicit ExampleGallery(QWidget *parent = nullptr);

Q_SIGNALS:
    void chosen(const QString &path);

private:
    void describe();

    QListWidget *m_list;
    QLabel *m_description;
};

}
