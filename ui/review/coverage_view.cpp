// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/coverage_view.h"

#include "ui/look/core_words.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

/// Below these values the scale of the heat shows no differences, as they do not matter.
constexpr double kLeastHottestDegrees = 0.05;
constexpr double kLeastHottestPx = 0.5;

std::optional<double> degreesOf(const std::optional<Radians>& angle) {
    return angle ? std::optional(Degrees(*angle).value()) : std::nullopt;
}

} // namespace

CoverageView::CoverageView(QWidget* parent) : SurveyPlanView(parent) {
    setAccessibleName(tr("Coverage of the room"));
}

void CoverageView::setRows(const std::vector<ReviewRow>& rows) {
    m_rows = rows;
    refresh();
}

void CoverageView::setMeasure(CoverageMeasure measure) {
    m_measure = measure;
    refresh();
}

std::optional<double> CoverageView::measured(const ReviewRow& row) const {
    switch (m_measure) {
    case CoverageMeasure::Standing:
        return std::nullopt;
    case CoverageMeasure::Residual:
        return degreesOf(row.residual);
    case CoverageMeasure::Sigma:
        return degreesOf(row.sigmaYaw);
    case CoverageMeasure::Error:
        return row.errorPx;
    }
    return std::nullopt;
}

double CoverageView::greatest() const {
    double greatest = m_measure == CoverageMeasure::Error ? kLeastHottestPx : kLeastHottestDegrees;
    for (const ReviewRow& row : m_rows) {
        if (const auto value = measured(row); value && std::isfinite(*value)) {
            greatest = std::max(greatest, *value);
        }
    }
    return greatest;
}

QString CoverageView::valueText(double value) const {
    if (std::isinf(value)) {
        return tr("not found");
    }
    return m_measure == CoverageMeasure::Error ? tr("%L1 px").arg(value, 0, 'f', 1)
                                               : tr("%L1°").arg(value, 0, 'f', 3);
}

QString CoverageView::hottest() const {
    if (m_measure == CoverageMeasure::Standing) {
        return {};
    }
    const bool isMore = std::any_of(m_rows.begin(), m_rows.end(), [this](const ReviewRow& row) {
        return std::isinf(measured(row).value_or(0));
    });
    return isMore ? tr("%1 and more").arg(valueText(greatest())) : valueText(greatest());
}

std::vector<StationMark> CoverageView::marks(const SurveyState& /*survey*/) const {
    const double scale = greatest();
    std::vector<StationMark> marks;
    for (const ReviewRow& row : m_rows) {
        if (!row.isPlaced) {
            continue;
        }
        StationMark mark;
        mark.id = row.station;
        mark.positionM = row.positionM.head<2>();
        mark.name = row.stationName;
        mark.standing = row.standing;
        mark.note = standingText(row.standing);
        if (const auto value = measured(row)) {
            mark.heat = std::min(1.0, *value / scale);
            mark.note = valueText(*value);
        }
        if (!row.flags.isEmpty()) {
            mark.note += QStringLiteral(": ") + coreWords(row.flags.first());
        }
        marks.push_back(std::move(mark));
    }
    return marks;
}

namespace {

/// The signs of the standings with their words. A line may end only between two of them.
QString signsText() {
    constexpr QChar kNoBreak(0x00A0);
    QStringList words;
    for (const Standing standing :
         {Standing::Missing, Standing::Taken, Standing::Doubtful, Standing::Failed, Standing::Rejected}) {
        QString sign = standingSign(standing) + kNoBreak + standingText(standing);
        words << sign.replace(QLatin1Char(' '), kNoBreak);
    }
    return words.join(kNoBreak + QStringLiteral("  "));
}

constexpr int kMarginPx = 4;
constexpr int kWrapped = Qt::TextWordWrap | Qt::AlignVCenter | Qt::AlignLeft;

} // namespace

CoverageLegend::CoverageLegend(QWidget* parent) : QWidget(parent) {
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred); // a fixed one keeps to sizeHint()
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    setAccessibleName(tr("Legend of the plan"));
}

void CoverageLegend::setHottest(const QString& hottest) {
    m_hottest = hottest;
    updateGeometry();
    update();
}

QSize CoverageLegend::sizeHint() const {
    constexpr int kUsualPx = 240;
    return {kUsualPx, heightForWidth(kUsualPx)};
}

QSize CoverageLegend::minimumSizeHint() const {
    constexpr int kNarrowestPx = 120;
    return {kNarrowestPx, fontMetrics().height() + 2 * kMarginPx};
}

int CoverageLegend::heightForWidth(int width) const {
    constexpr int kHighest = 1000;
    const QRect room(0, 0, std::max(1, width - 2 * kMarginPx), kHighest);
    const int lines = m_hottest.isEmpty()
                          ? fontMetrics().boundingRect(room, Qt::TextWordWrap, signsText()).height()
                          : fontMetrics().height();
    return lines + 2 * kMarginPx;
}

void CoverageLegend::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect inside = rect().adjusted(kMarginPx, 0, -kMarginPx, 0);
    if (m_hottest.isEmpty()) {
        painter.drawText(inside, kWrapped, signsText());
        return;
    }
    const QString from = QStringLiteral("0");
    const int left = inside.left() + fontMetrics().horizontalAdvance(from) + 6;
    const int right = inside.right() - fontMetrics().horizontalAdvance(m_hottest) - 6;
    const QRect bar(left, rect().center().y() - 5, std::max(8, right - left), 10);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 8;
    for (int i = 0; i <= kStops; ++i) {
        const double at = static_cast<double>(i) / kStops;
        gradient.setColorAt(at, PlanView::heatColour(at));
    }
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignLeft, from);
    painter.drawText(inside, Qt::AlignVCenter | Qt::AlignRight, m_hottest);
    painter.fillRect(bar, gradient);
}

} // namespace spherewalk::ui
