// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/remote/remote_form.h"

#include "ui/look/side_panel.h"
#include "ui/remote/phone_remote.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QUrl>

#include <algorithm>

namespace spherewalk::ui {

namespace {

constexpr int kNarrowestPx = 400;

/// A label to be read and typed by somebody who stands beside.
QLabel* largeLabel(const char* name, QWidget* parent) {
    constexpr double kLarger = 1.8;
    auto* label = new QLabel(parent);
    label->setObjectName(name);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    QFont font = label->font();
    font.setPointSizeF(kLarger * font.pointSizeF());
    font.setBold(true);
    label->setFont(font);
    return label;
}

QLabel* wrappedLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

} // namespace

RemoteForm::RemoteForm(PhoneRemote& remote, const QList<QHostAddress>& addresses, QWidget* parent)
    : QDialog(parent),
      m_remote(remote),
      m_addresses(new QComboBox(this)),
      m_toggle(new QPushButton(this)),
      m_url(largeLabel("remoteAddress", this)),
      m_code(largeLabel("remoteCode", this)),
      m_state(wrappedLabel({}, this)),
      m_renew(new QPushButton(this)) {
    setObjectName("remoteForm");
    setWindowTitle(tr("Phone as remote"));
    setMinimumWidth(kNarrowestPx);
    m_addresses->setObjectName("remoteNetwork");
    m_addresses->setToolTip(tr("This computer's address in the network that the phone is in, too."));
    for (const QHostAddress& address : addresses) {
        m_addresses->addItem(address.toString());
    }
    m_addresses->setCurrentText(QUrl(remote.url()).host());
    m_toggle->setObjectName("toggleRemote");
    m_renew->setObjectName("renewRemoteCode");
    m_state->setObjectName("remoteState");
    auto* warning = wrappedLabel(
        tr("Nothing is encrypted on the way: whoever can listen in this network can read along and take the "
           "remote over. Use a network that you trust, and turn the remote off when you are done."),
        this);
    makeWarning(warning);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    buttons->addButton(m_toggle, QDialogButtonBox::ActionRole);
    buttons->addButton(m_renew, QDialogButtonBox::ActionRole);
    auto* form = new QFormLayout(this);
    form->addRow(
        wrappedLabel(tr("A phone or tablet on the cart shows the next station, shoots, and shows the "
                        "last photo. Open the address in its browser, and type the code there."),
                     this));
    form->addRow(tr("&Network:"), m_addresses);
    form->addRow(tr("Address:"), m_url);
    form->addRow(tr("Code:"), m_code);
    form->addRow(m_state);
    form->addRow(warning);
    form->addRow(buttons);
    connect(m_toggle, &QPushButton::clicked, this, &RemoteForm::toggle);
    connect(m_renew, &QPushButton::clicked, &m_remote, &PhoneRemote::renewCode);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(&m_remote, &PhoneRemote::changed, this, &RemoteForm::showAll);
    showAll();
}

void RemoteForm::toggle() {
    if (m_remote.isOn()) {
        m_remote.turnOff();
    } else {
        m_remote.turnOn(QHostAddress(m_addresses->currentText()));
    }
}

QString RemoteForm::stateText() const {
    if (!m_remote.isOn()) {
        return m_addresses->count() == 0 ? tr("This computer is in no local network. Connect it to the "
                                              "network that the phone is in.")
                                         : m_remote.sentence();
    }
    if (m_remote.pairing().isPaired()) {
        return tr("The device at %1 is the remote.").arg(m_remote.device().toString());
    }
    return m_remote.pairing().code().empty()
               ? tr("Wrong codes came too often, and the code is void. Make a new one.")
               : tr("No device is paired yet.");
}

void RemoteForm::showAll() {
    const bool isOn = m_remote.isOn();
    const QString none = QString::fromUtf8("–");
    const QString code = isOn ? QString::fromStdString(m_remote.pairing().code()) : QString();
    m_addresses->setEnabled(!isOn && m_addresses->count() > 0);
    m_toggle->setEnabled(m_addresses->count() > 0);
    m_toggle->setText(isOn ? tr("&Turn off") : tr("&Turn on"));
    m_url->setText(isOn ? m_remote.url() : none);
    m_code->setText(code.isEmpty() ? none : code.left(3) + " " + code.mid(3));
    m_state->setText(stateText());
    m_renew->setVisible(isOn);
    m_renew->setText(m_remote.pairing().isPaired() ? tr("&Let go of the device") : tr("New &code"));
    growToFit();
}

void RemoteForm::showEvent(QShowEvent* event) {
    QDialog::showEvent(event);
    growToFit();
}

/// Makes room for words that wrap, which a form does not count in its size.
void RemoteForm::growToFit() {
    layout()->activate();
    const int wide = std::max(width(), sizeHint().width());
    resize(wide, std::max(height(), heightForWidth(wide)));
}

} // namespace spherewalk::ui
