// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_panel.h"

#include "ui/look/side_panel.h"
#include "ui/plan/plan_draft.h"

#include "spherewalk/survey/marking.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>
#include <QTableView>
#include <QVBoxLayout>

#include <cmath>

namespace spherewalk::ui {

namespace {

enum FieldKey { kStep = 1, kRail, kClearance, kCeiling, kPhotoPace, kRailPace, kHeights };

QString heightsText(const std::vector<double>& heightsM) {
    QStringList parts;
    for (const double height : heightsM) {
        parts << QLocale().toString(height, 'f', 2);
    }
    return parts.join("; ");
}

/// Reads heights from a text; nothing if the text has other words.
std::optional<std::vector<double>> heightsOf(const QString& text) {
    std::vector<double> result;
    for (const QString& part : text.split(';', Qt::SkipEmptyParts)) {
        bool isNumber = false;
        const double height = QLocale().toDouble(part.trimmed(), &isNumber);
        if (!isNumber) {
            return std::nullopt;
        }
        result.push_back(height);
    }
    return result.empty() ? std::nullopt : std::optional(result);
}

} // namespace

CornerModel::CornerModel(PlanEditor& editor, QObject* parent)
    : QAbstractTableModel(parent), m_editor(editor) {
    connect(&editor, &PlanEditor::draftChanged, this, &CornerModel::follow);
    connect(&editor, &PlanEditor::selectionChanged, this, &CornerModel::follow);
    follow();
}

void CornerModel::follow() {
    const int obstacles = static_cast<int>(m_editor.draft().room.obstacles.size());
    const int polygon = std::clamp(m_editor.selected().polygon, 0, obstacles);
    const int rows = static_cast<int>(m_editor.polygon(polygon).size());
    if (polygon != m_polygon || rows != m_rows) {
        beginResetModel();
        m_polygon = polygon;
        m_rows = rows;
        endResetModel();
    } else if (rows > 0) {
        emit dataChanged(index(0, 0), index(rows - 1, 1));
    }
}

int CornerModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int CornerModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : 2;
}

QVariant CornerModel::data(const QModelIndex& index, int role) const {
    const Eigen::Vector2d& corner = m_editor.polygon(m_polygon)[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole) {
        return QLocale().toString(corner[index.column()], 'f', 3);
    }
    if (role == Qt::EditRole) {
        return corner[index.column()];
    }
    return role == Qt::TextAlignmentRole ? QVariant(Qt::AlignRight | Qt::AlignVCenter) : QVariant();
}

QVariant CornerModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    if (orientation == Qt::Horizontal) {
        return section == 0 ? tr("x (m)") : tr("y (m)");
    }
    return m_polygon == PlanPart::kOutline ? QString::fromStdString(survey::cornerName(section))
                                           : QString::number(section + 1);
}

Qt::ItemFlags CornerModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    return m_editor.isLocked() ? flags : flags | Qt::ItemIsEditable;
}

bool CornerModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    bool isNumber = false;
    const double metres = value.toDouble(&isNumber);
    if (role != Qt::EditRole || !isNumber || !std::isfinite(metres) || m_editor.isLocked()) {
        return false;
    }
    Eigen::Vector2d corner = m_editor.polygon(m_polygon)[static_cast<std::size_t>(index.row())];
    corner[index.column()] = metres;
    m_editor.endRun();
    m_editor.moveCorner({m_polygon, index.row()}, corner);
    m_editor.endRun();
    return true;
}

PlanPanel::PlanPanel(PlanEditor& editor, QWidget* parent) : QWidget(parent), m_editor(editor) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(makeResult());
    m_grid = makeGrid();
    layout->addWidget(m_grid);
    layout->addWidget(makeCorners(), 1);
    connect(&editor, &PlanEditor::draftChanged, this, &PlanPanel::showDraft);
    connect(&editor, &PlanEditor::selectionChanged, this, &PlanPanel::showDraft);
    connect(&editor, &PlanEditor::outcomeChanged, this, &PlanPanel::showOutcome);
    showDraft();
    showOutcome();
}

QWidget* PlanPanel::makeResult() {
    auto* section = new Section(tr("What it comes to"), this);
    m_counts = section->addWords();
    m_counts->setObjectName("planCounts");
    m_walk = section->addWords();
    m_floor = section->addWords();
    m_uncovered = section->addWords();
    m_uncovered->setObjectName("planUncovered");
    m_problem = section->addWords();
    m_problem->setObjectName("planProblem");
    QFont large = m_counts->font();
    large.setPointSizeF(1.35 * large.pointSizeF());
    large.setBold(true);
    m_counts->setFont(large);
    return section;
}

QDoubleSpinBox* PlanPanel::makeNumber(const QString& objectName, double least, double most, double step,
                                      int digits, const QString& unit) {
    auto* box = new QDoubleSpinBox(this);
    box->setObjectName(objectName);
    box->setDecimals(digits);
    box->setRange(least, most);
    box->setSingleStep(step);
    box->setSuffix(" " + unit);
    box->setKeyboardTracking(false); // a number that is being typed is none yet
    return box;
}

void PlanPanel::bind(QDoubleSpinBox* box, int key, const std::function<void(PlanDraft&, double)>& apply) {
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, key, apply](double value) {
        m_editor.change(
            tr("Change number"), [&](PlanDraft& draft) { apply(draft, value); }, key);
    });
}

QWidget* PlanPanel::makeGrid() {
    auto* section = new Section(tr("Grid and rail"), this);
    auto* form = section->addForm();
    m_step = makeNumber("step", 0.05, 5, 0.05, 2, tr("m"));
    m_rail = makeNumber("railLength", 0, 20, 0.1, 2, tr("m"));
    m_railStops = new QLabel(this);
    m_clearance = makeNumber("clearance", 0, 5, 0.05, 2, tr("m"));
    m_heights = new QLineEdit(this);
    m_heights->setObjectName("heights");
    m_ceiling = makeNumber("ceiling", 0.5, 1000, 0.1, 2, tr("m"));
    m_photoPace = makeNumber("photoPace", 1, 600, 1, 0, tr("s"));
    m_railPace = makeNumber("railPace", 0, 3600, 5, 0, tr("s"));
    section->addRow(form, tr("S&tep"), m_step, tr("Between neighbouring stations, in both directions."));
    section->addRow(form, tr("&Rail length"), m_rail, tr("From the first to the last stop of the cart."));
    form->addRow(QString(), m_railStops);
    section->addRow(form, tr("Cle&arance"), m_clearance,
                    tr("Least distance from a stop to walls and obstacles."));
    section->addRow(
        form, tr("Len&s height (m)"), m_heights,
        tr("Of the lens above the floor; several heights, separated by semicolons, make layers."));
    section->addRow(form, tr("Ceilin&g"), m_ceiling, tr("Height of the ceiling above the floor."));
    section->addRow(form, tr("Time a &photo"), m_photoPace, tr("With moving the cart to the next stop."));
    section->addRow(form, tr("Time a rai&l"), m_railPace, tr("Carrying the rail and laying it anew."));
    bind(m_step, kStep, [this](PlanDraft& draft, double value) {
        draft.options.stepM = value;
        draft.options.railStops = railStops(m_rail->value(), value);
    });
    bind(m_rail, kRail, [](PlanDraft& draft, double value) {
        draft.options.railStops = railStops(value, draft.options.stepM);
    });
    bind(m_clearance, kClearance, [](PlanDraft& draft, double value) { draft.options.clearanceM = value; });
    bind(m_ceiling, kCeiling, [](PlanDraft& draft, double value) { draft.room.ceilingM = value; });
    bind(m_photoPace, kPhotoPace,
         [](PlanDraft& draft, double value) { draft.options.secondsPerPhoto = value; });
    bind(m_railPace, kRailPace,
         [](PlanDraft& draft, double value) { draft.options.secondsPerPlacement = value; });
    connect(m_heights, &QLineEdit::editingFinished, this, &PlanPanel::applyHeights);
    return section;
}

void PlanPanel::applyHeights() {
    const auto heights = heightsOf(m_heights->text());
    if (heights && *heights != m_editor.draft().options.heightsM) {
        m_editor.change(
            tr("Change number"),
            [&](PlanDraft& draft) {
                draft.options.heightsM = *heights;
                draft.options.areHeightsGuessed = false;
            },
            kHeights);
    }
    showDraft();
}

QWidget* PlanPanel::makeCorners() {
    auto* section = new Section(QString(), this);
    m_cornersTitle = section->title();
    m_corners = new QTableView(section);
    m_corners->setTabKeyNavigation(false); // Tab leaves the table; arrows go from corner to corner
    m_corners->setObjectName("corners");
    m_corners->setAccessibleName(tr("Corners"));
    m_corners->setModel(new CornerModel(m_editor, this));
    m_corners->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_corners->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_corners->setMinimumHeight(110);
    section->layout()->addWidget(m_corners);
    connect(
        m_corners->selectionModel(), &QItemSelectionModel::currentChanged, this,
        [this](const QModelIndex& at) {
            if (at.isValid()) {
                m_editor.select({static_cast<const CornerModel*>(m_corners->model())->polygon(), at.row()});
            }
        });
    return section;
}

void PlanPanel::showDraft() {
    const PlanDraft& draft = m_editor.draft();
    const auto show = [](QDoubleSpinBox* box, double value) {
        const QSignalBlocker quiet(box);
        box->setValue(value);
    };
    show(m_step, draft.options.stepM);
    if (railStops(m_rail->value(), draft.options.stepM) !=
        draft.options.railStops) { // else as the user typed it
        show(m_rail, railLengthM(draft.options.railStops, draft.options.stepM));
    }
    m_railStops->setText(tr("%n stop(s)", nullptr, draft.options.railStops));
    show(m_clearance, draft.options.clearanceM);
    show(m_ceiling, draft.room.ceilingM);
    show(m_photoPace, draft.options.secondsPerPhoto);
    show(m_railPace, draft.options.secondsPerPlacement);
    m_heights->setText(heightsText(draft.options.heightsM));
    const int polygon = m_editor.selected().polygon;
    m_cornersTitle->setText(polygon > PlanPart::kOutline ? tr("Corners of obstacle %1").arg(polygon)
                                                         : tr("Corners of the room"));
    m_grid->setEnabled(!m_editor.isLocked());
    for (QWidget* ofRails :
         std::initializer_list<QWidget*>{m_step, m_rail, m_clearance, m_heights, m_photoPace, m_railPace}) {
        ofRails->setEnabled(draft.hasRails);
    }
}

void PlanPanel::showOutcome() {
    const PlanOutcome& outcome = m_editor.outcome();
    const bool isPlan = outcome.problem.isEmpty();
    m_problem->setVisible(!isPlan);
    m_problem->setText(outcome.problem);
    for (QLabel* label : {m_counts, m_walk, m_floor, m_uncovered}) {
        label->setVisible(isPlan);
    }
    const bool hasRails = m_editor.draft().hasRails;
    m_walk->setVisible(isPlan && hasRails);
    m_floor->setVisible(isPlan && outcome.report.floorM2 > 0);
    m_counts->setText(hasRails || outcome.report.stations > 0 ? countsText(outcome.report)
                                                              : tr("Photos by hand, of unknown places"));
    m_walk->setText(walkText(outcome.report));
    m_floor->setText(floorText(outcome.report));
    m_uncovered->setText(uncoveredText(outcome.report, m_editor.draft().options).join("\n"));
}

} // namespace spherewalk::ui
