// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/camera_panel.h"

#include "ui/look/icon.h"
#include "ui/look/icon_label.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QSpinBox>
#include <QVBoxLayout>

namespace spherewalk::ui {

namespace {

constexpr auto kAddressKey = "camera/address";
constexpr auto kHideKey = "camera/hideSeconds";

} // namespace

CameraPanel::CameraPanel(CaptureDesk& desk, QWidget* parent)
    : QWidget(parent),
      m_desk(desk),
      m_address(new QLineEdit(QSettings().value(kAddressKey, "192.168.1.1").toString(), this)),
      m_connect(new QPushButton(ui::icon("connect"), tr("&Connect"), this)),
      m_practice(new QPushButton(ui::icon("capture"), tr("&Practice camera"), this)),
      m_hide(new QSpinBox(this)),
      m_automatic(new QCheckBox(tr("Shoot by &itself"), this)) {
    m_address->setObjectName("cameraAddress");
    m_address->setAccessibleName(tr("Address of the camera"));
    m_address->setToolTip(tr("Address of the camera, with :port if it is not 80."));
    m_connect->setObjectName("connectCamera");
    m_connect->setToolTip(tr("Ask the camera at this address how it is."));
    m_practice->setObjectName("practiceCamera");
    m_practice->setToolTip(tr("Start a camera inside of the program, which photographs a practice room."));
    m_hide->setObjectName("hideSeconds");
    m_hide->setAccessibleName(tr("Time to hide"));
    m_hide->setRange(0, 60);
    m_hide->setSuffix(" " + tr("s"));
    m_hide->setSpecialValueText(tr("none"));
    m_hide->setToolTip(tr("From the key to the shot, so that nobody is in the picture."));
    m_automatic->setObjectName("automatic");
    m_automatic->setToolTip(tr("The practice camera moves from station to station without the key."));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(m_address, 0, 0);
    grid->addWidget(m_connect, 0, 1);
    grid->addWidget(m_practice, 0, 2);
    auto* hideRow = new QHBoxLayout;
    auto* hideLabel = new QLabel(tr("Time to &hide:"), this);
    hideLabel->setBuddy(m_hide);
    hideRow->addWidget(hideLabel);
    hideRow->addWidget(m_hide);
    hideRow->addStretch();
    hideRow->addWidget(m_automatic);
    grid->addLayout(hideRow, 1, 0, 1, 3);
    grid->addWidget(makeStatus(), 2, 0, 1, 3);
    grid->setColumnStretch(0, 1);
    const auto connectCamera = [this] {
        QSettings().setValue(kAddressKey, m_address->text());
        m_desk.connectTo(m_address->text());
    };
    connect(m_connect, &QPushButton::clicked, this, connectCamera);
    connect(m_address, &QLineEdit::returnPressed, this, connectCamera);
    connect(m_practice, &QPushButton::clicked, this, [this] { m_desk.connectToPractice(); });
    connect(m_hide, &QSpinBox::valueChanged, this, [this](int seconds) {
        QSettings().setValue(kHideKey, seconds);
        m_desk.setHideSeconds(seconds);
    });
    m_hide->setValue(QSettings().value(kHideKey, 0).toInt());
    connect(m_automatic, &QCheckBox::toggled, this, [this](bool isOn) { m_desk.setAutomatic(isOn); });
    connect(&m_desk, &CaptureDesk::changed, this, &CameraPanel::showAll);
    showAll();
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
    for (QWidget* widget : std::initializer_list<QWidget*>{m_address, m_connect, m_practice, m_automatic}) {
        widget->setEnabled(isFree);
    }
    m_automatic->setVisible(m_desk.hasPracticeCamera());
    const auto& status = m_desk.camera();
    const bool isConnecting = m_desk.state() == CaptureDesk::State::Connecting;
    const QString unknown = QString::fromUtf8("–");
    m_model->setText(isConnecting ? tr("connecting...") : status ? status->model : tr("no camera"));
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
