// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/store/survey_store.h"
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

/// Returns ISO and shutter time of the survey's latest photo, as the camera chose them; nothing if no photo
/// says so.
std::optional<survey::CaptureProfile> latestExposure(const store::SurveyStore& store);

/// A dialog for the exposure settings of a survey. profile() returns nothing for "as the camera is set".
class ProfileForm : public QDialog {
    Q_OBJECT

  public:
    /// last: what the camera chose for the latest photo, which the dialog offers to keep.
    explicit ProfileForm(const std::optional<survey::CaptureProfile>& profile,
                         const std::optional<survey::CaptureProfile>& last = {}, QWidget* parent = nullptr);

    std::optional<survey::CaptureProfile> profile() const;

  private:
    QComboBox* addChoice(const QString& name, const QString& label, const QString& hint);
    void fillChoices();
    void show(const survey::CaptureProfile& profile);
    void followChoices();
    void keep(const survey::CaptureProfile& last);

    QCheckBox* m_asItIs;
    QComboBox* m_iso;
    QComboBox* m_shutter;
    QComboBox* m_compensation;
    QComboBox* m_whiteBalance;
    QComboBox* m_width;
};

} // namespace spherewalk::ui
