// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/told.h"

#include <QLabel>
#include <QList>

namespace spherewalk::ui {

/// Shows sentences. Each that has a cure ends in a link there, which Tab reaches and Return follows. The
/// label is plain text, and takes no focus from the keyboard, where nothing has a cure.
class ToldLabel : public QLabel {
    Q_OBJECT

  public:
    explicit ToldLabel(QWidget* parent = nullptr);

    void tell(const Told& told) { tell(QList<Told>{told}); }

    /// Shows one sentence a line.
    void tell(const QList<Told>& lines);

    /// Returns the sentences as they read, without links.
    QString words() const { return m_words; }

    bool hasLink() const { return textFormat() == Qt::RichText; }

  protected:
    void focusInEvent(QFocusEvent* event) override;

  private:
    QString m_words;
};

} // namespace spherewalk::ui
