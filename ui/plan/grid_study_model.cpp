// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/grid_study_model.h"

#include "ui/look/quantity_text.h"
#include "ui/preview/rung_words.h"

#include <QFont>
#include <QLocale>

#include <algorithm>

namespace spherewalk::ui {

namespace {

QString minutesText(double minutes) {
    return durationText(std::chrono::duration<double>(60 * minutes));
}

QString centimetresText(double metres) {
    return GridStudyModel::tr("%L1 cm").arg(100 * metres, 0, 'f', 0);
}

} // namespace

void GridStudyModel::setStudy(const jobs::GridStudy& study) {
    beginResetModel();
    m_tolerancePx = study.tolerancePx;
    m_scenes.clear();
    m_lines.clear();
    for (const jobs::GridAnswer& answer : study.answers) {
        m_scenes.push_back(answer.scene);
    }
    for (const jobs::GridRow& row : study.rows) {
        if (m_lines.empty() || m_lines.back().stepM != row.stepM) {
            Line line{row.stepM, {}, std::vector<std::optional<double>>(m_scenes.size())};
            for (const jobs::GridCost& cost : study.costs) {
                if (cost.stepM == row.stepM) {
                    line.cost = cost;
                }
            }
            m_lines.push_back(std::move(line));
        }
        const auto scene = std::find(m_scenes.begin(), m_scenes.end(), row.scene);
        if (scene != m_scenes.end()) {
            m_lines.back().errorsPx[static_cast<std::size_t>(scene - m_scenes.begin())] = row.p95Px;
        }
    }
    endResetModel();
}

int GridStudyModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

int GridStudyModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : FirstSceneColumn + static_cast<int>(m_scenes.size());
}

std::optional<double> GridStudyModel::errorPx(const Line& line, int column) const {
    return line.errorsPx.at(static_cast<std::size_t>(column - FirstSceneColumn));
}

QString GridStudyModel::text(const Line& line, int column) const {
    switch (column) {
    case StepColumn:
        return centimetresText(line.stepM);
    case PhotosColumn:
        return line.cost ? QLocale().toString(line.cost->photos) : QString();
    case TimeColumn:
        return line.cost ? minutesText(line.cost->minutes) : QString();
    default: {
        const auto error = errorPx(line, column);
        constexpr double kLarge = 99.95; // whose tenths say nothing, and would not fit
        return error ? tr("%L1 px").arg(*error, 0, 'f', *error < kLarge ? 1 : 0) : QStringLiteral("–");
    }
    }
}

QVariant GridStudyModel::data(const QModelIndex& index, int role) const {
    const Line& line = m_lines.at(static_cast<std::size_t>(index.row()));
    const bool isError = index.column() >= FirstSceneColumn;
    const auto error = isError ? errorPx(line, index.column()) : std::nullopt;
    const bool holds = error && *error <= m_tolerancePx;
    switch (role) {
    case Qt::DisplayRole:
        return holds ? tr("✓ %1").arg(text(line, index.column())) : text(line, index.column());
    case Qt::TextAlignmentRole:
        return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::FontRole: {
        QFont font;
        font.setBold(holds);
        return font;
    }
    case Qt::ToolTipRole:
        return holds     ? tr("95 of 100 places are displaced by no more: within the tolerance.")
               : error   ? tr("95 of 100 places are displaced by no more: beyond the tolerance.")
               : isError ? tr("The pictures had too little in common to say.")
                         : QString();
    default:
        return {};
    }
}

QVariant GridStudyModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
        return {};
    }
    switch (section) {
    case StepColumn:
        return tr("Step");
    case PhotosColumn:
        return tr("Photos");
    case TimeColumn:
        return tr("Time");
    default:
        return sceneWord(m_scenes.at(static_cast<std::size_t>(section - FirstSceneColumn)));
    }
}

QString answerWords(const jobs::GridAnswer& answer) {
    const QString step = centimetresText(answer.stepM.value());
    const QString words = GridStudyModel::tr("%1 with %2").arg(step, sceneWord(answer.scene));
    return answer.cost ? GridStudyModel::tr("%1: %n photo(s), %2", nullptr, answer.cost->photos)
                             .arg(words, minutesText(answer.cost->minutes))
                       : words;
}

} // namespace spherewalk::ui
