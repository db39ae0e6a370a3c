// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame/mode.h"

#include "spherewalk/store/records.h"

#include <QList>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace spherewalk::ui {

enum class ReviewFilter;
class CoverageLegend;
class CoverageView;
class PanoramaView;
class ReviewPresenter;
class TaskList;
class ToldLabel;

/// The page where a person looks at photos, compares them, and accepts or rejects them.
class ReviewMode : public Mode {
    Q_OBJECT

  public:
    explicit ReviewMode(TaskList& tasks, QWidget* parent = nullptr);
    /// thumbnailFolder: the folder that keeps small pictures.
    ReviewMode(TaskList& tasks, std::filesystem::path thumbnailFolder, QWidget* parent);

    void setSession(SurveySession* session) override;
    void activated() override;
    /// part: "doubtful" lists the doubtful photos, or the failed ones without any; "regions" those with
    /// private regions.
    void showPart(const QString& part) override;
    QList<Key> keys() const override;

  private:
    QWidget* makeList();
    QWidget* makeViewer();
    QWidget* makePlan();
    QAction* makeAction(const QString& text, const QList<QKeySequence>& keys, const QString& toolTip);
    void list(ReviewFilter filter);
    void decide(store::Decision decision);
    std::vector<std::int64_t> chosen() const;
    void showRows();
    void showBatch();
    void showRegions();
    void showCurrent();
    void showNeighbours();
    void showNote();
    void keepNote();
    void compare(int comparison);
    void chooseReport();
    void showMeasure();
    void showSheet(bool isSheet);

    PanoramaView* m_viewer;
    ReviewPresenter* m_presenter;
    QListView* m_list = nullptr;
    QComboBox* m_filter = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel* m_summary = nullptr;
    QPushButton* m_acceptGood = nullptr;
    QPushButton* m_check = nullptr;
    QPushButton* m_align = nullptr;
    ToldLabel* m_reasons = nullptr;
    QAction* m_sheet = nullptr;   ///< Whether the list is a contact sheet.
    QList<QWidget*> m_besideList; ///< What a contact sheet takes the room of.
    QLineEdit* m_note = nullptr;
    std::optional<std::int64_t> m_notePhoto; ///< The photo that m_note belongs to.
    QComboBox* m_neighbour = nullptr;
    QComboBox* m_comparison = nullptr;
    CoverageView* m_plan = nullptr;
    CoverageLegend* m_legend = nullptr;
    QComboBox* m_measure = nullptr;
    QPushButton* m_report = nullptr;
    QLabel* m_errorWords = nullptr;
    QList<QAction*> m_decisions;
    std::optional<std::int64_t> m_regionsOf; ///< The photo whose first region was turned to.
};

} // namespace spherewalk::ui
