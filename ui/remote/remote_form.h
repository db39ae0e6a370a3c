// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QHostAddress>
#include <QList>

class QComboBox;
class QLabel;
class QPushButton;

namespace spherewalk::ui {

class PhoneRemote;

/// Turns the phone remote on and off, and shows what a phone needs: address and code. The remote stays on
/// when the form is closed.
class RemoteForm : public QDialog {
    Q_OBJECT

  public:
    /// addresses: those of this computer that a phone can reach. Owner: the remote outlives the form.
    RemoteForm(PhoneRemote& remote, const QList<QHostAddress>& addresses, QWidget* parent = nullptr);

  protected:
    void showEvent(QShowEvent* event) override;

  private:
    void toggle();
    void growToFit();
    void showAll();
    QString stateText() const;

    PhoneRemote& m_remote;
    QComboBox* m_addresses;
    QPushButton* m_toggle;
    QLabel* m_url;
    QLabel* m_code;
    QLabel* m_state;
    QPushButton* m_renew;
};

} // namespace spherewalk::ui
