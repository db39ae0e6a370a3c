// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/new_survey_form.h"

#include "ui/look/primary_button.h"

#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

namespace spherewalk::ui {

namespace {

constexpr auto kPlaceKey = "surveysPlace";

} // namespace

QString surveysPlace() {
    const QString own = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Spherewalk";
    QString place = QSettings().value(kPlaceKey, own).toString();
    if (!QDir().mkpath(place)) {
        place = QDir::homePath();
    }
    return place;
}

NewSurveyForm::NewSurveyForm(QWidget* parent)
    : Section(tr("New survey"), parent),
      m_name(new QLineEdit(this)),
      m_place(new QPushButton(this)),
      m_create(new QPushButton(tr("&Create survey"), this)) {
    m_name->setObjectName("surveyName");
    m_create->setObjectName("createSurvey");
    makePrimary(m_create);
    QFormLayout* form = addForm();
    addRow(form, tr("&Name"), m_name, tr("What the room is called; the survey's folder gets this name."));
    addRow(form, tr("Kept &in"), m_place, tr("The folder in which the survey's folder is made."));
    layout()->addWidget(m_create);
    connect(m_place, &QPushButton::clicked, this, &NewSurveyForm::choosePlace);
    connect(m_name, &QLineEdit::textChanged, this, &NewSurveyForm::showState);
    const auto create = [this] {
        if (m_create->isEnabled()) {
            emit createRequested(folder());
        }
    };
    connect(m_name, &QLineEdit::returnPressed, this, create);
    connect(m_create, &QPushButton::clicked, this, create);
}

void NewSurveyForm::propose() {
    m_placeFolder = surveysPlace();
    for (int number = 1;; ++number) {
        m_name->setText(number == 1 ? tr("room") : tr("room %1").arg(number));
        if (!QFileInfo::exists(folder())) {
            break;
        }
    }
    showState();
}

QString NewSurveyForm::folder() const {
    return m_placeFolder + "/" + m_name->text().trimmed() + ".spherewalk";
}

void NewSurveyForm::setPossible(bool isPossible) {
    m_isPossible = isPossible;
    showState();
}

void NewSurveyForm::showState() {
    const QString name = m_name->text().trimmed();
    const bool isTaken = QFileInfo::exists(folder());
    m_create->setEnabled(m_isPossible && !name.isEmpty() && !name.contains('/') && !isTaken);
    m_create->setToolTip(isTaken ? tr("There is a survey of this name already.")
                                 : tr("Makes the survey on the disk."));
    m_place->setText(QDir(m_placeFolder).dirName());
    m_place->setToolTip(QDir::toNativeSeparators(m_placeFolder));
}

void NewSurveyForm::choosePlace() {
    const QString place =
        QFileDialog::getExistingDirectory(this, tr("Where surveys are kept"), m_placeFolder);
    if (!place.isEmpty()) {
        m_placeFolder = place;
        QSettings().setValue(kPlaceKey, place);
        showState();
    }
}

} // namespace spherewalk::ui
