// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/capture/preview_feed.h"

#include <QWidget>

namespace spherewalk::ui {

/// The live preview's newest picture, as wide as there is room, or what is the matter.
class PreviewView : public QWidget {
    Q_OBJECT

  public:
    explicit PreviewView(const PreviewFeed& feed, QWidget* parent = nullptr);

    QSize sizeHint() const override;

    bool hasHeightForWidth() const override { return true; }

    int heightForWidth(int width) const override { return width / 2; }

    /// What stands in place of a picture.
    QString words() const;

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void follow();

    const PreviewFeed& m_feed;
};

} // namespace spherewalk::ui
