// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <QDialog>

#include "preferences.h"

class QCheckBox;
class QComboBox;
class QSpinBox;

namespace romanesco {

/// Shows the preferences as they are; each change is in force, and written, at once.
class PreferencesDialog : public QDialog
{
    Q_OBJECT
public:
    explicit PreferencesDialog(QWidget *parent = nullptr);

Q_SIGNALS:
    void changed(const romanesco::Preferences &preferences);

private:
    void fillFonts();
    void take();

    Preferences m_preferences;
    /// In the order of the enumeration.
    QComboBox *m_appearance;
    /// The system's first, whose data is empty.
    QComboBox *m_family;
    QSpinBox *m_size;
    QCheckBox *m_wrap;
    QCheckBox *m_reopen;
};

}
