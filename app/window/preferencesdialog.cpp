// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "preferencesdialog.h"

#include <algorithm>

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFontDatabase>
#include <QFormLayout>
#include <QSpinBox>

namespace romanesco {

PreferencesDialog::PreferencesDialog(QWidget *parent)
    : QDialog(parent)
    , m_preferences(Preferences::read())
    , m_appearance(new QComboBox)
    , m_family(new QComboBox)
    , m_size(new QSpinBox)
    , m_wrap(new QCheckBox(tr("&Wrap long lines")))
    , m_reopen(new QCheckBox(tr("&Open at the start what was open at the end")))
{
    setWindowTitle(tr("Preferences"));
    m_appearance->addItems({tr("As the System"), tr("Light"), tr("Dark")});
    m_appearance->setCurrentIndex(static_cast<int>(m_preferences.appearance));
    fillFonts();
    m_size->setRange(Preferences::leastFontSize - 1, Preferences::greatestFontSize);
    m_size->setSpecialValueText(tr("The System's"));
    m_size->setSuffix(tr(" pt"));
    m_size->setValue(std::max(m_preferences.fontSize, m_size->minimum()));
    m_wrap->setChecked(m_preferences.wrapsLines);
    m_reopen->setChecked(m_preferences.reopensTexts);

    auto *form = new QFormLayout(this);
    form->addRow(tr("&Appearance"), m_appearance);
    form->addRow(tr("&Font of texts"), m_family);
    form->addRow(tr("&Size"), m_size);
    form->addRow(m_wrap);
    form->addRow(m_reopen);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    for (const QComboBox *box : {m_appearance, m_family}) {
        connect(box, &QComboBox::currentIndexChanged, this, &PreferencesDialog::take);
    }
    connect(m_size, &QSpinBox::valueChanged, this, &PreferencesDialog::take);
    for (const QCheckBox *box : {m_wrap, m_reopen}) {
        connect(box, &QCheckBox::toggled, this, &PreferencesDialog::take);
    }
}

void PreferencesDialog::fillFonts()
{
    const QString system = QFontDatabase::systemFont(QFontDatabase::FixedFont).family();
    m_family->addItem(tr("The System's (%1)").arg(system), QString());
    for (const QString &family : QFontDatabase::families()) {
        if (QFontDatabase::isFixedPitch(family) && !QFontDatabase::isPrivateFamily(family)) {
            m_family->addItem(family, family);
        }
    }
    // One that is not there now may be there again.
    const int index = m_family->findData(m_preferences.fontFamily);
    if (index < 0) {
        m_family->addItem(m_preferences.fontFamily, m_preferences.fontFamily);
    }
    m_family->setCurrentIndex(index < 0 ? m_family->count() - 1 : index);
}

void PreferencesDialog::take()
{
    const Preferences before = m_preferences;
    m_preferences.appearance = static_cast<Preferences::Appearance>(m_appearance->currentIndex());
    m_preferences.fontFamily = m_family->currentData().toString();
    m_preferences.fontSize = m_size->value() < Preferences::leastFontSize ? 0 : m_size->value();
    m_preferences.wrapsLines = m_wrap->isChecked();
    m_preferences.reopensTexts = m_reopen->isChecked();
    m_preferences.write();
    if (m_preferences.appearance != before.appearance) {
        applyAppearance(m_preferences.appearance);
    }
    Q_EMIT changed(m_preferences);
}

}
