// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/profile_form.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/photo/metadata.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

using survey::CaptureProfile;
using survey::WhiteBalance;

namespace {

QString whiteBalanceWords(WhiteBalance balance) {
    switch (balance) {
    case WhiteBalance::Auto:
        return ProfileForm::tr("automatic");
    case WhiteBalance::Daylight:
        return ProfileForm::tr("daylight");
    case WhiteBalance::Shade:
        return ProfileForm::tr("shade");
    case WhiteBalance::Cloudy:
        return ProfileForm::tr("cloudy");
    case WhiteBalance::Incandescent:
        return ProfileForm::tr("incandescent");
    case WhiteBalance::Fluorescent:
        return ProfileForm::tr("fluorescent, white");
    case WhiteBalance::WarmWhiteFluorescent:
        return ProfileForm::tr("fluorescent, warm white");
    case WhiteBalance::DaylightFluorescent:
        return ProfileForm::tr("fluorescent, daylight");
    case WhiteBalance::DayWhiteFluorescent:
        return ProfileForm::tr("fluorescent, day white");
    case WhiteBalance::BulbFluorescent:
        return ProfileForm::tr("fluorescent bulb");
    }
    return {};
}

QString shutterWords(double seconds) {
    return QString::fromStdString(survey::shutterText(seconds)) + " " + ProfileForm::tr("s");
}

QString compensationWords(double ev) {
    return (ev > 0 ? "+" : "") + QLocale().toString(ev, 'f', 1) + " " + ProfileForm::tr("EV");
}

QString temperatureWords(int kelvin) {
    return QString("%1 K").arg(kelvin);
}

QString widthWords(int width) {
    return QString::fromUtf8("%1 × %2").arg(width).arg(width / 2);
}

/// Chooses the entry with these data, and adds a missing one.
void choose(QComboBox* box, const QVariant& data, const QString& words) {
    int index = box->findData(data);
    if (index < 0) {
        box->addItem(words, data);
        index = box->count() - 1;
    }
    box->setCurrentIndex(index);
}

/// Returns the usual shutter time that differs from this one by rounding only, or else this one.
double listed(double seconds) {
    for (const double usual : survey::usualShutterTimes()) {
        constexpr double kSame = 1e-3;
        if (std::abs(usual - seconds) <= kSame * usual) {
            return usual;
        }
    }
    return seconds;
}

} // namespace

QString profileWords(const std::optional<CaptureProfile>& profile) {
    if (!profile) {
        return ProfileForm::tr("as the camera is set");
    }
    QStringList words;
    if (profile->iso) {
        words << QString("ISO %1").arg(*profile->iso);
    }
    if (profile->shutterS) {
        words << shutterWords(*profile->shutterS);
    }
    if (profile->compensationEv != 0) {
        words << compensationWords(profile->compensationEv);
    }
    if (profile->colourTemperatureK) {
        words << temperatureWords(*profile->colourTemperatureK);
    } else if (profile->whiteBalance != WhiteBalance::Auto) {
        words << whiteBalanceWords(profile->whiteBalance);
    }
    if (profile->photoWidth) {
        words << widthWords(*profile->photoWidth);
    }
    return words.isEmpty() ? ProfileForm::tr("automatic") : words.join(", ");
}

std::optional<CaptureProfile> latestExposure(const store::SurveyStore& store) {
    const std::vector<store::PhotoRecord> photos = store.chosenPhotos();
    const auto latest = std::max_element(photos.begin(), photos.end(),
                                         [](const auto& a, const auto& b) { return a.id < b.id; });
    if (latest == photos.end()) {
        return std::nullopt;
    }
    try {
        const std::filesystem::path file = store.photoFolder() / latest->fileName;
        const photo::PhotoMetadata metadata = photo::readMetadata(readFile(file), file.string());
        CaptureProfile profile;
        profile.iso = metadata.iso;
        profile.shutterS = metadata.exposureS;
        return profile.iso && profile.shutterS ? std::optional(profile) : std::nullopt;
    } catch (const Error&) { // the review says what is wrong with a photo
        return std::nullopt;
    }
}

ProfileForm::ProfileForm(const std::optional<CaptureProfile>& profile,
                         const std::optional<CaptureProfile>& last, QWidget* parent)
    : QDialog(parent), m_asItIs(new QCheckBox(tr("Leave it as the camera is set"), this)) {
    setWindowTitle(tr("Exposure of the photos"));
    auto* column = new QVBoxLayout(this);
    auto* words = new QLabel(
        tr("Photos of one room fit each other best if all are exposed alike: fix ISO, shutter time and white "
           "balance where the light does not change."),
        this);
    words->setWordWrap(true);
    column->addWidget(words);
    m_asItIs->setObjectName("asItIs");
    column->addWidget(m_asItIs);
    auto* form = new QFormLayout;
    column->addLayout(form);
    m_iso = addChoice("iso", tr("&ISO"), tr("Fixed, or chosen by the camera for each photo."));
    m_shutter =
        addChoice("shutter", tr("&Shutter time"), tr("Fixed, or chosen by the camera for each photo."));
    m_compensation = addChoice("compensation", tr("&Brightness"),
                               tr("How much brighter or darker than the camera thinks right."));
    m_whiteBalance = addChoice("whiteBalance", tr("&White balance"), tr("The colour of the light."));
    m_width = addChoice("photoWidth", tr("&Photo size"), tr("Of those that the camera offers."));
    auto* keep = new QPushButton(this);
    keep->setObjectName("keepLast");
    keep->setText(last ? tr("&Keep what the camera chose last: %1").arg(profileWords(last))
                       : tr("&Keep what the camera chose last"));
    keep->setToolTip(tr("ISO and shutter time of the latest photo of this survey."));
    keep->setEnabled(last.has_value());
    connect(keep, &QPushButton::clicked, this, [this, last] { this->keep(*last); });
    column->addWidget(keep);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    column->addWidget(buttons);
    fillChoices();
    show(profile.value_or(CaptureProfile{}));
    m_asItIs->setChecked(!profile);
    connect(m_asItIs, &QCheckBox::toggled, this, &ProfileForm::followChoices);
    connect(m_iso, &QComboBox::currentIndexChanged, this, &ProfileForm::followChoices);
    connect(m_shutter, &QComboBox::currentIndexChanged, this, &ProfileForm::followChoices);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    followChoices();
}

QComboBox* ProfileForm::addChoice(const QString& name, const QString& label, const QString& hint) {
    auto* box = new QComboBox(this);
    box->setObjectName(name);
    box->setToolTip(hint);
    box->setAccessibleName(QString(label).remove('&'));
    findChild<QFormLayout*>()->addRow(label, box);
    return box;
}

void ProfileForm::fillChoices() {
    m_iso->addItem(tr("automatic"), 0);
    for (const int iso : survey::usualIsoSteps()) {
        m_iso->addItem(QString::number(iso), iso);
    }
    m_shutter->addItem(tr("automatic"), 0.0);
    for (const double seconds : survey::usualShutterTimes()) {
        m_shutter->addItem(shutterWords(seconds), seconds);
    }
    for (const double ev : survey::usualCompensations()) {
        m_compensation->addItem(compensationWords(ev), ev);
    }
    // White balances by their number; temperatures, which are larger, by their kelvins.
    for (int i = 0; i <= static_cast<int>(WhiteBalance::BulbFluorescent); ++i) {
        m_whiteBalance->addItem(whiteBalanceWords(static_cast<WhiteBalance>(i)), i);
    }
    for (const int kelvin : {2700, 3000, 3500, 4000, 4500, 5000, 5500, 6000, 6500}) {
        m_whiteBalance->addItem(temperatureWords(kelvin), kelvin);
    }
    m_width->addItem(tr("largest"), 0);
    for (const int width : {5376, 5504, 6720, 11008}) {
        m_width->addItem(widthWords(width), width);
    }
}

void ProfileForm::show(const CaptureProfile& profile) {
    const int iso = profile.iso.value_or(0);
    choose(m_iso, iso, QString::number(iso));
    const double seconds = listed(profile.shutterS.value_or(0));
    choose(m_shutter, seconds, shutterWords(seconds));
    choose(m_compensation, profile.compensationEv, compensationWords(profile.compensationEv));
    const int kelvin = profile.colourTemperatureK.value_or(0);
    choose(m_whiteBalance, kelvin > 0 ? kelvin : static_cast<int>(profile.whiteBalance),
           temperatureWords(kelvin));
    const int width = profile.photoWidth.value_or(0);
    choose(m_width, width, widthWords(width));
}

/// Fixes what the camera chose. What is not known of it stays.
void ProfileForm::keep(const CaptureProfile& last) {
    m_asItIs->setChecked(false);
    CaptureProfile fixed = profile().value_or(CaptureProfile{});
    fixed.iso = last.iso;
    fixed.shutterS = last.shutterS;
    fixed.compensationEv = 0;
    show(fixed);
}

void ProfileForm::followChoices() {
    const bool isSet = !m_asItIs->isChecked();
    for (QComboBox* box : {m_iso, m_shutter, m_whiteBalance, m_width}) {
        box->setEnabled(isSet);
    }
    const bool isManual = m_iso->currentIndex() > 0 && m_shutter->currentIndex() > 0;
    m_compensation->setEnabled(isSet && !isManual); // else there is nothing that it could change
}

std::optional<CaptureProfile> ProfileForm::profile() const {
    if (m_asItIs->isChecked()) {
        return std::nullopt;
    }
    CaptureProfile profile;
    if (const int iso = m_iso->currentData().toInt(); iso > 0) {
        profile.iso = iso;
    }
    if (const double seconds = m_shutter->currentData().toDouble(); seconds > 0) {
        profile.shutterS = seconds;
    }
    profile.compensationEv = m_compensation->isEnabled() ? m_compensation->currentData().toDouble() : 0;
    const int light = m_whiteBalance->currentData().toInt();
    if (light > static_cast<int>(WhiteBalance::BulbFluorescent)) {
        profile.colourTemperatureK = light;
    } else {
        profile.whiteBalance = static_cast<WhiteBalance>(light);
    }
    if (const int width = m_width->currentData().toInt(); width > 0) {
        profile.photoWidth = width;
    }
    return profile;
}

} // namespace spherewalk::ui
