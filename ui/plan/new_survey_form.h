// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/section.h"

class QLineEdit;
class QPushButton;

namespace spherewalk::ui {

/// Name and place of a survey that is to be made.
class NewSurveyForm : public Section {
    Q_OBJECT

  public:
    explicit NewSurveyForm(QWidget* parent = nullptr);

    /// A name that is free in the place where surveys are kept.
    void propose();
    void setPossible(bool isPossible);
    /// Where the survey would be: place/name.spherewalk.
    QString folder() const;

  signals:
    void createRequested(const QString& folder);

  private:
    void choosePlace();
    void showState();

    QLineEdit* m_name;
    QPushButton* m_place;
    QPushButton* m_create;
    QString m_placeFolder;
    bool m_isPossible = false;
};

/// Where surveys are kept unless the user says otherwise; made if need be.
QString surveysPlace();

} // namespace spherewalk::ui
