// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/capture_profile.h"

#include <QDialog>

#include <optional>

class QCheckBox;
class QComboBox;
class QDialogButtonBox;
class QLabel;

namespace spherewalk::ui {

/// Describes exposure settings: "automatic", "as the camera is set", or what is fixed: "ISO 200, 1/60 s".
QString profileWords(const std::optional<survey::CaptureProfile>& profile);

/// A dialog for the exposure settings of a survey. profile() returns nothing for "as the camera is set".
class ProfileForm : public QDialog {
    Q_OBJECT

  public:
    explicit ProfileForm(const std::optional<survey::CaptureProfile>& profile, QWidget* parent = nullptr);

    std::optional<survey::CaptureProfile> profile() const;

  private:
    QComboBox* addChoice(const QString& name, const QString& label, const QString& hint);
    void fillChoices();
    void show(const survey::CaptureProfile& profile);
    void followChoices();

    QCheckBox* m_asItIs;
    QComboBox* m_iso;
    QComboBox* m_shutter;
    QComboBox* m_compensation;
    QComboBox* m_whiteBalance;
    QComboBox* m_width;
};

} // namespace spherewalk::ui
