// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_panel.h"

#include "ui/capture/camera_login.h"
#include "ui/capture/desk_words.h"
#include "ui/capture/profile_form.h"
#include "ui/look/icon.h"
#include "ui/look/side_panel.h"
#include "ui/look/told_label.h"

#include <QCheckBox>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

#include <algorithm>

namespace spherewalk::ui {

namespace {

constexpr auto kAddressKey = "camera/address";
constexpr auto kHideKey = "camera/hideSeconds";

} // namespace

CameraPanel::CameraPanel(CaptureDesk& desk, CameraFinder& finder, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_finder(finder),
      m_address(new QLineEdit(QSettings().value(kAddressKey, "192.168.1.1").toString(), this)),
      m_connect(new QPushButton(ui::icon("connect"), tr("&Connect"), this)),
      m_practice(new QPushButton(ui::icon("capture"), QString(), this)),
      m_practiceWords(new QLabel(practiceWords(), this)),
      m_hide(new QSpinBox(this)),
      m_automatic(new QCheckBox(tr("Shoot by &itself"), this)),
      m_remote(new QPushButton(this)) {
    m_address->setObjectName("cameraAddress");
    m_address->setAccessibleName(tr("Address of the camera"));
    m_address->setToolTip(tr("Address of the camera, with :port if it is not 80."));
    m_connect->setObjectName("connectCamera");
    m_connect->setToolTip(tr("Ask the camera at this address how it is."));
    m_practice->setObjectName("practiceCamera");
    m_practice->setToolTip(tr("The camera inside of the program, which photographs a practice room."));
    m_practiceWords->setObjectName("practiceWords");
    m_practiceWords->setWordWrap(true);
    makeWarning(m_practiceWords);
    m_hide->setObjectName("hideSeconds");
    m_hide->setAccessibleName(tr("Time to hide"));
    m_hide->setRange(0, 60);
    m_hide->setSuffix(" " + tr("s"));
    m_hide->setSpecialValueText(tr("none"));
    m_hide->setToolTip(tr("From the key to the shot, so that nobody is in the picture."));
    m_automatic->setObjectName("automatic");
    m_automatic->setToolTip(tr("The practice camera moves from station to station without the key."));
    m_remote->setObjectName("phoneRemote");
    m_remote->setToolTip(
        tr("A phone or tablet on the cart shows the next station, shoots, and shows the last "
           "photo."));
    m_remote->setFocusPolicy(Qt::TabFocus); // a click must not take the key away from the page
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_address, 0, 0);
    grid->addWidget(m_connect, 0, 1);
    grid->addWidget(m_practice, 0, 2);
    auto* hideRow = new QHBoxLayout;
    auto* hideLabel = new QLabel(tr("Ti&me to hide:"), this);
    hideLabel->setBuddy(m_hide);
    hideRow->addWidget(hideLabel);
    hideRow->addWidget(m_hide);
    hideRow->addStretch();
    hideRow->addWidget(m_automatic);
    hideRow->addWidget(m_remote);
    grid->addLayout(hideRow, 1, 0, 1, 3);
    m_preview = new PreviewView(m_desk.preview(), this);
    m_preview->setObjectName("livePreview");
    grid->addWidget(makeFinder(), 2, 0, 1, 3);
    grid->addWidget(m_practiceWords, 3, 0, 1, 3);
    grid->addWidget(makeStatus(), 4, 0, 1, 3);
    grid->addWidget(makeExposure(), 5, 0, 1, 3);
    grid->addWidget(m_preview, 6, 0, 1, 3);
    grid->setColumnStretch(0, 1);
    const auto connectCamera = [this] { connectAt(m_address->text()); };
    connect(m_connect, &QPushButton::clicked, this, connectCamera);
    connect(m_address, &QLineEdit::returnPressed, this, connectCamera);
    connect(m_practice, &QPushButton::clicked, this, &CameraPanel::togglePractice);
    connect(m_hide, &QSpinBox::valueChanged, this, [this](int seconds) {
        QSettings().setValue(kHideKey, seconds);
        m_desk.setHideSeconds(seconds);
    });
    m_hide->setValue(QSettings().value(kHideKey, 0).toInt());
    connect(m_automatic, &QCheckBox::toggled, this, [this](bool isOn) { m_desk.setAutomatic(isOn); });
    connect(&m_desk, &CaptureDesk::changed, this, &CameraPanel::showAll);
    connect(&m_desk.login(), &CameraLogin::wanted, this, &CameraPanel::askLogin);
    connect(&m_finder, &CameraFinder::changed, this, &CameraPanel::showFound);
    connect(m_remote, &QPushButton::clicked, this, &CameraPanel::remoteWanted);
    showRemote(false);
    showFound();
    showAll();
}

void CameraPanel::showRemote(bool isOn) {
    m_remote->setText(isOn ? tr("Phone as remote: on...") : tr("Phone as remote..."));
}

void CameraPanel::showPart(const QString& part) {
    if (part == QLatin1String("address")) {
        m_address->setFocus(Qt::ShortcutFocusReason);
        m_address->selectAll();
    } else if (part == QLatin1String("exposure")) {
        m_profile->setFocus(Qt::ShortcutFocusReason);
    }
}

/// Asks first where practice photos would come into a survey of a real room.
void CameraPanel::togglePractice() {
    if (m_desk.hasPracticeCamera()) {
        return m_desk.disconnectCamera();
    }
    if (m_desk.session() == nullptr || m_desk.isPracticeRoom()) {
        return m_desk.connectToPractice();
    }
    auto* question =
        new QMessageBox(QMessageBox::Warning, tr("Practice camera"),
                        tr("The practice camera photographs a room of the program. Its photos would become "
                           "photos of %1.")
                            .arg(m_desk.session()->name()),
                        QMessageBox::Cancel, this);
    question->setObjectName("practiceQuestion");
    question->addButton(tr("&Use it here"), QMessageBox::AcceptRole);
    question->setDefaultButton(QMessageBox::Cancel);
    question->setAttribute(Qt::WA_DeleteOnClose);
    connect(question, &QDialog::accepted, &m_desk, &CaptureDesk::connectToPractice);
    question->open();
}

void CameraPanel::connectAt(const QString& address) {
    QSettings().setValue(kAddressKey, address);
    m_desk.connectTo(address);
}

QWidget* CameraPanel::makeFinder() {
    auto* finder = new QWidget(this);
    auto* row = new QHBoxLayout(finder);
    row->setContentsMargins(0, 0, 0, 0);
    m_find = new QPushButton(tr("Fi&nd cameras"), finder);
    m_find->setObjectName("findCameras");
    m_find->setToolTip(tr("Looks where cameras usually are, and for those that announce themselves on the "
                          "network."));
    m_found = new QComboBox(finder);
    m_found->setObjectName("foundCameras");
    m_found->setAccessibleName(tr("Cameras that were found"));
    m_found->setToolTip(tr("Choose the camera to connect to."));
    m_findWords = new ToldLabel(finder);
    m_findWords->setObjectName("findWords");
    row->addWidget(m_find);
    row->addWidget(m_found);
    row->addWidget(m_findWords, 1);
    row->addStretch(); // for a row without words
    connect(m_find, &QPushButton::clicked, &m_finder, &CameraFinder::find);
    connect(m_found, &QComboBox::activated, this, [this](int index) {
        if (index > 0) {
            m_address->setText(m_found->itemData(index).toString());
            connectAt(m_address->text());
        }
    });
    return finder;
}

QWidget* CameraPanel::makeExposure() {
    auto* exposure = new QWidget(this);
    auto* row = new QHBoxLayout(exposure);
    row->setContentsMargins(0, 0, 0, 0);
    m_profile = new QPushButton(exposure);
    m_profile->setObjectName("captureProfile");
    m_profile->setToolTip(tr("How the camera is set for the photos of this survey."));
    m_showPreview = new QPushButton(tr("&Live preview"), exposure);
    m_showPreview->setObjectName("showPreview");
    m_showPreview->setCheckable(true);
    // A click must not take the key away from the page.
    for (QPushButton* button : {m_profile, m_showPreview}) {
        button->setFocusPolicy(Qt::TabFocus);
    }
    m_showPreview->setToolTip(tr("What the camera sees, until the picture is taken."));
    row->addWidget(m_profile, 1);
    row->addWidget(m_showPreview);
    connect(m_profile, &QPushButton::clicked, this, &CameraPanel::editProfile);
    connect(m_showPreview, &QPushButton::toggled, this, [this](bool isOn) { m_desk.setShowsPreview(isOn); });
    return exposure;
}

/// Shows the form beside the live picture, which shows what its numbers do.
void CameraPanel::editProfile() {
    if (m_form && m_form->isVisible()) {
        return m_form->raise();
    }
    auto* form = new ProfileForm(m_desk.profile(), latestExposure(m_desk.session()->store()), this);
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this, [this, form] { m_desk.setProfile(form->profile()); });
    connect(&m_desk, &CaptureDesk::changed, form, [this, form, session = m_desk.session()] {
        if (m_desk.isRunning() || m_desk.session() != session) {
            form->reject(); // too late for what it says
        }
    });
    m_form = form;
    constexpr int kGapPx = 12;
    const QPoint beside = mapToGlobal(QPoint(-form->sizeHint().width() - kGapPx, 0));
    form->move(std::max(0, beside.x()), beside.y());
    form->setVisible(true);
}

void CameraPanel::askLogin(const camera::Endpoint& endpoint, bool wasRefused) {
    if (m_login && m_login->isVisible()) {
        return; // several clients ask
    }
    auto* form = new LoginForm(endpoint, wasRefused, this);
    m_login = form;
    form->setAttribute(Qt::WA_DeleteOnClose);
    connect(form, &QDialog::accepted, this,
            [this, form, endpoint] { m_desk.giveLogin(endpoint, form->credentials(), form->isKept()); });
    form->open();
}

void CameraPanel::showFound() {
    m_find->setEnabled(!m_finder.isLooking());
    m_findWords->tell(m_finder.told());
    m_found->clear();
    m_found->addItem(tr("Choose..."));
    for (const camera::FoundCamera& camera : m_finder.cameras()) {
        m_found->addItem(CameraFinder::words(camera), QString::fromStdString(camera.place.endpoint.name()));
    }
    m_found->setVisible(m_found->count() > 1);
}

QWidget* CameraPanel::makeStatus() {
    auto* status = new QWidget(this);
    auto* row = new QHBoxLayout(status);
    row->setContentsMargins(0, 4, 0, 0);
    const auto add = [&](const QString& iconName, const QString& name) {
        constexpr int kIconPx = 18;
        row->addWidget(new IconLabel(iconName, kIconPx, status));
        auto* label = new QLabel(status);
        label->setAccessibleName(name);
        label->setObjectName(iconName);
        row->addWidget(label);
        row->addSpacing(10);
        return label;
    };
    m_model = add("capture", tr("Camera"));
    m_battery = add("battery", tr("Battery"));
    m_storage = add("storage", tr("Storage of the camera"));
    m_heat = add("thermometer", tr("Temperature of the camera"));
    row->addStretch();
    return status;
}

void CameraPanel::showAll() {
    const bool isFree = !m_desk.isRunning() && m_desk.state() != CaptureDesk::State::Connecting;
    for (QWidget* widget :
         std::initializer_list<QWidget*>{m_address, m_connect, m_practice, m_automatic, m_found}) {
        widget->setEnabled(isFree);
    }
    const bool isPractice = m_desk.hasPracticeCamera();
    m_practice->setText(isPractice ? tr("Leave the &practice camera") : tr("&Practice camera"));
    m_practiceWords->setVisible(isPractice);
    m_findWords->setVisible(!m_desk.camera()); // a camera that answers needs no advice
    m_automatic->setVisible(isPractice);
    m_automatic->setChecked(m_desk.isAutomatic());
    m_profile->setText(tr("E&xposure: %1").arg(profileWords(m_desk.profile())));
    m_profile->setEnabled(m_desk.session() != nullptr && !m_desk.isRunning());
    m_preview->setVisible(m_desk.showsPreview());
    const auto& status = m_desk.camera();
    const bool isConnecting = m_desk.state() == CaptureDesk::State::Connecting;
    const QString unknown = QString::fromUtf8("–");
    m_model->setText(isConnecting        ? tr("connecting...")
                     : !status           ? tr("no camera")
                     : m_desk.isSilent() ? tr("no answer")
                     : isPractice        ? tr("practice camera")
                                         : status->model);
    m_battery->setText(status && status->batteryFraction
                           ? tr("%1 %").arg(qRound(100 * *status->batteryFraction)) +
                                 (status->isCharging ? " " + tr("(charging)") : QString())
                           : unknown);
    m_storage->setText(status && status->remainingPhotos
                           ? tr("%n photo(s)", nullptr, int(*status->remainingPhotos))
                           : unknown);
    using Heat = CameraStatus::Heat;
    m_heat->setText(!status                      ? unknown
                    : status->heat == Heat::Hot  ? tr("too hot")
                    : status->heat == Heat::Warm ? tr("warm")
                                                 : tr("normal"));
}

} // namespace spherewalk::ui
