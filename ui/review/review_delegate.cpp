// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_delegate.h"

#include "ui/review/review_model.h"

#include <QApplication>
#include <QPainter>

namespace spherewalk::ui {

namespace {

constexpr int kThumbnailWidth = 112;
constexpr int kThumbnailHeight = kThumbnailWidth / 2;
constexpr int kGap = 6;

/// The picture, or what stands in its place.
void paintThumbnail(QPainter& painter, const QRect& box, const QModelIndex& index, const QPalette& palette) {
    const auto picture = index.data(Qt::DecorationRole).value<QImage>();
    if (!picture.isNull()) {
        painter.drawImage(box, picture);
        return;
    }
    painter.fillRect(box, palette.color(QPalette::AlternateBase));
    painter.setPen(palette.color(QPalette::Mid));
    painter.drawRect(box.adjusted(0, 0, -1, -1));
    const auto standing = static_cast<Standing>(index.data(ReviewModel::StandingRole).toInt());
    const QString words = standing == Standing::Missing ? ReviewDelegate::tr("no photo")
                          : index.data(ReviewModel::UnreadableRole).toBool()
                              ? ReviewDelegate::tr("unreadable")
                              : QString();
    painter.setPen(palette.color(QPalette::PlaceholderText));
    painter.drawText(box, Qt::AlignCenter, words);
}

} // namespace

QSize ReviewDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& /*index*/) const {
    return {kThumbnailWidth + 160, std::max(kThumbnailHeight, 3 * option.fontMetrics.height()) + 2 * kGap};
}

void ReviewDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                           const QModelIndex& index) const {
    QStyleOptionViewItem row = option;
    row.text.clear();
    row.icon = {};
    const QStyle* style = option.widget != nullptr ? option.widget->style() : QApplication::style();
    style->drawPrimitive(QStyle::PE_PanelItemViewItem, &row, painter, option.widget);
    painter->save();
    const QRect box = option.rect.adjusted(kGap, kGap, -kGap, -kGap);
    paintThumbnail(*painter,
                   {box.left(), box.center().y() - kThumbnailHeight / 2, kThumbnailWidth, kThumbnailHeight},
                   index, option.palette);
    const bool isSelected = option.state.testFlag(QStyle::State_Selected);
    const QColor ink = option.palette.color(isSelected ? QPalette::HighlightedText : QPalette::Text);
    const QRect words = box.adjusted(kThumbnailWidth + 2 * kGap, 0, 0, 0);
    const int line = option.fontMetrics.height();
    const auto put = [&](int at, const QString& text) {
        painter->drawText(QRect(words.left(), words.top() + at * line, words.width(), line), Qt::AlignVCenter,
                          option.fontMetrics.elidedText(text, Qt::ElideRight, words.width()));
    };
    painter->setPen(ink);
    QFont bold = option.font;
    bold.setBold(true);
    painter->setFont(bold);
    put(0, index.data(Qt::DisplayRole).toString());
    painter->setFont(option.font);
    const auto standing = static_cast<Standing>(index.data(ReviewModel::StandingRole).toInt());
    const QString error = index.data(ReviewModel::ErrorRole).toString();
    put(1, standingSign(standing) + QLatin1Char(' ') + standingText(standing) +
               (error.isEmpty() ? error : QStringLiteral(" · ") + error));
    const QString note = index.data(ReviewModel::NoteRole).toString();
    painter->setOpacity(0.75);
    put(2, note.isEmpty() ? index.data(ReviewModel::ReasonRole).toString() : note);
    painter->restore();
}

} // namespace spherewalk::ui
