// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/preview_mode.h"

#include "ui/fields/camera_box.h"
#include "ui/fields/scene_fields.h"
#include "ui/look/told_label.h"
#include "ui/preview/drive_view.h"
#include "ui/preview/object_fields.h"
#include "ui/preview/path_player.h"
#include "ui/preview/preview_presenter.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStandardItemModel>

#include <algorithm>
#include <cmath>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr double kLeastAimM = 0.05; ///< The heading follows a drag from this distance on.
constexpr int kBestScene = -1;      ///< Stands for the dataset's choice in the data of a combo box.

} // namespace

PreviewMode::PreviewMode(TaskList& tasks, QWidget* parent)
    : Mode("preview", tr("Preview"), tr("Drive a robot and see what its camera would see"), parent),
      m_presenter(new PreviewPresenter(tasks, this)) {
    m_view = new DriveView(*m_presenter, this);
    m_view->setObjectName("view");
    m_map = new RobotMap(*m_presenter, this);
    m_map->setObjectName("map");
    m_map->setAccessibleName(tr("Where the robot is"));
    m_map->setToolTip(tr("Click to put the robot there, drag to turn it; with Shift, put the object there"));
    auto* side = new QWidget(this);
    auto* sideLayout = new QVBoxLayout(side);
    sideLayout->setContentsMargins(0, 0, 0, 0);
    sideLayout->addWidget(m_map, 1);
    sideLayout->addWidget(makeControls());
    auto* columns = new QSplitter(this);
    auto* stage = new QWidget(this);
    auto* stageLayout = new QVBoxLayout(stage);
    stageLayout->setContentsMargins(0, 0, 0, 0);
    stageLayout->addWidget(m_view, 1);
    stageLayout->addWidget(new PathPlayer(*m_presenter, stage));
    columns->addWidget(stage);
    columns->addWidget(side);
    columns->setStretchFactor(0, 3);
    columns->setStretchFactor(1, 2);
    columns->setSizes({760, 440});
    columns->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->addWidget(makeBar());
    layout->addWidget(columns, 1);
    connect(m_map, &PlanCanvas::pressedAt, this, &PreviewMode::placeRobot);
    connect(m_map, &PlanCanvas::draggedTo, this, &PreviewMode::aimRobot);
    connect(m_presenter, &PreviewPresenter::datasetChanged, this, &PreviewMode::showDataset);
    connect(m_presenter, &PreviewPresenter::datasetChanged, this, &Mode::subjectChanged);
    connect(m_presenter, &PreviewPresenter::viewsChanged, this, &PreviewMode::showViews);
    connect(m_presenter, &PreviewPresenter::recordingChanged, this, &PreviewMode::showRecording);
    connect(m_presenter, &PreviewPresenter::message, this, &Mode::message);
    showDataset();
    showRecording();
}

void PreviewMode::setSession(SurveySession* session) {
    m_presenter->setSession(session);
}

void PreviewMode::activated() {
    (m_presenter->dataset() != nullptr ? static_cast<QWidget*>(m_view) : m_make)->setFocus();
}

Mode::Subject PreviewMode::subject() const {
    if (!m_presenter->isForeign()) {
        return {};
    }
    const render::DatasetInfo& info = m_presenter->dataset()->info();
    return {tr("%1 (dataset)").arg(QString::fromStdString(info.name)),
            tr("%n photo(s) in the dataset", nullptr, static_cast<int>(info.photos.size()))};
}

QList<Mode::Key> PreviewMode::keys() const {
    return DriveView::keys();
}

void PreviewMode::showPart(const QString& part) {
    if (!part.isEmpty()) {
        m_presenter->openDataset(part);
    }
}

QWidget* PreviewMode::makeBar() {
    auto* bar = new QWidget(this);
    auto* layout = new QHBoxLayout(bar);
    layout->setContentsMargins(0, 0, 0, 0);
    m_make = new QPushButton(tr("&Preview this survey"), bar);
    m_make->setObjectName("make");
    m_make->setToolTip(tr("Export the survey to a temporary folder and look at it; nothing is kept"));
    connect(m_make, &QPushButton::clicked, m_presenter, &PreviewPresenter::makeDataset);
    auto* open = new QPushButton(tr("Open a &dataset..."), bar);
    open->setObjectName("open");
    open->setToolTip(tr("Look at a dataset that was exported before"));
    connect(open, &QPushButton::clicked, this, &PreviewMode::chooseDataset);
    m_depth = new QCheckBox(tr("&With depth"), bar);
    m_depth->setObjectName("withDepth");
    m_depth->setChecked(true);
    m_depth->setToolTip(tr("The depth of each pixel follows while you drive, in surveys of up to %1 photos")
                            .arg(PreviewPresenter::kMostDeepened));
    connect(m_depth, &QCheckBox::toggled, m_presenter, &PreviewPresenter::setWantsDepth);
    m_what = new ToldLabel(bar);
    m_what->setObjectName("what");
    m_rate = new QLabel(bar);
    m_rate->setObjectName("rate");
    m_rate->setMinimumWidth(m_rate->fontMetrics().horizontalAdvance(tr("%1 views/s").arg(999)));
    m_rate->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_record = new QPushButton(tr("&Record"), bar);
    m_record->setObjectName("record");
    m_record->setCheckable(true);
    m_record->setToolTip(tr("Record the path that the robot takes"));
    connect(m_record, &QPushButton::toggled, m_presenter, &PreviewPresenter::setRecording);
    m_save = new QPushButton(tr("&Save frames..."), bar);
    m_save->setObjectName("save");
    m_save->setToolTip(tr("Render a frame at each pose of the recorded path, as the command walk does"));
    connect(m_save, &QPushButton::clicked, this, &PreviewMode::chooseFolder);
    layout->addWidget(m_make);
    layout->addWidget(m_depth);
    layout->addWidget(open);
    layout->addWidget(m_what, 1);
    layout->addWidget(m_rate);
    layout->addWidget(m_record);
    layout->addWidget(m_save);
    return bar;
}

PreviewMode::SideChoice PreviewMode::makeSide(const QString& name, QGridLayout& grid, int row) {
    SideChoice side;
    side.scene = new QComboBox(this);
    side.scene->setAccessibleName(tr("Scene model of view %1").arg(name));
    side.scene->setToolTip(tr("What places between photos are computed with, cheap to exact"));
    side.scene->addItem(autoSceneWords(nullptr, {}), kBestScene);
    side.scene->addItem(tr("None: nearest photo, turned"), static_cast<int>(render::SceneKind::None));
    side.scene->addItem(tr("Sphere"), static_cast<int>(render::SceneKind::Sphere));
    side.scene->addItem(tr("Room: walls, floor, ceiling"), static_cast<int>(render::SceneKind::Room));
    side.scene->addItem(tr("Depth of each pixel"), static_cast<int>(render::SceneKind::Depth));
    side.scene->addItem(tr("Blend: depth, photos mixed"), static_cast<int>(render::SceneKind::Blend));
    side.sampling = new QComboBox(this);
    side.sampling->setAccessibleName(tr("Sampling of view %1").arg(name));
    side.sampling->setToolTip(tr("How pixels are made, cheap to exact"));
    side.sampling->addItem(tr("Nearest"), static_cast<int>(render::Sampling::Nearest));
    side.sampling->addItem(tr("Bilinear"), static_cast<int>(render::Sampling::Bilinear));
    side.sampling->addItem(tr("Reduced"), static_cast<int>(render::Sampling::Reduced));
    side.sampling->addItem(tr("Footprint"), static_cast<int>(render::Sampling::Footprint));
    side.sampling->addItem(tr("Bicubic"), static_cast<int>(render::Sampling::Bicubic));
    side.sampling->addItem(autoSamplingWords(nullptr, {}), static_cast<int>(render::Sampling::Auto));
    side.sampling->setCurrentIndex(3);
    auto* label = new QLabel(name, this);
    grid.addWidget(label, row, 0);
    grid.addWidget(side.scene, row, 1);
    grid.addWidget(side.sampling, row, 2);
    for (QComboBox* choice : {side.scene, side.sampling}) {
        connect(choice, &QComboBox::currentIndexChanged, this, &PreviewMode::applySides);
    }
    return side;
}

QWidget* PreviewMode::makeControls() {
    auto* box = new QGroupBox(tr("Camera and view"), this);
    auto* grid = new QGridLayout(box);
    m_camera = new CameraBox(box);
    m_camera->setObjectName("camera");
    connect(m_camera, &CameraBox::message, this, &Mode::message);
    connect(m_camera, &CameraBox::cameraChanged, this, [this] {
        m_presenter->setCamera(m_camera->camera());
        showRungs();
    });
    grid->addWidget(new QLabel(tr("Camera"), box), 0, 0);
    grid->addWidget(m_camera, 0, 1, 1, 2);
    const auto spin = [&](const QString& name, double least, double most, double step, const QString& suffix,
                          const QString& toolTip) {
        auto* result = new QDoubleSpinBox(box);
        result->setObjectName(name);
        result->setRange(least, most);
        result->setSingleStep(step);
        result->setSuffix(suffix);
        result->setToolTip(toolTip);
        connect(result, &QDoubleSpinBox::valueChanged, this, &PreviewMode::applyMount);
        return result;
    };
    m_height = spin("height", 0.01, 20, 0.05, tr(" m high"), tr("Height of the camera above the floor"));
    m_pitch = spin("pitch", -90, 90, 5, tr("° down"), tr("How far the camera looks below the horizon"));
    m_height->setValue(m_presenter->mount().heightM);
    grid->addWidget(new QLabel(tr("Carried"), box), 1, 0);
    grid->addWidget(m_height, 1, 1);
    grid->addWidget(m_pitch, 1, 2);
    m_sides.push_back(makeSide(tr("View"), *grid, 2));
    m_split = new QCheckBox(tr("&Compare"), box);
    m_split->setObjectName("split");
    m_split->setToolTip(tr("Show a second view beside the first, made another way"));
    m_sides.push_back(makeSide(tr("B"), *grid, 3));
    m_sides[0].sampling->setObjectName("samplingA");
    m_sides[1].sampling->setObjectName("samplingB");
    m_sides[0].scene->setObjectName("sceneA");
    m_sides[1].scene->setObjectName("sceneB");
    m_sides[1].scene->setCurrentIndex(1);
    delete grid->itemAtPosition(3, 0)->widget(); // the box takes its place
    grid->addWidget(m_split, 3, 0);
    connect(m_split, &QCheckBox::toggled, this, &PreviewMode::applySides);
    makeOtherCamera(*grid, 4);
    makeOverlays(*grid, 5);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(2, 1);
    applySides();
    return box;
}

/// Makes the choice of a camera of its own for the second view.
void PreviewMode::makeOtherCamera(QGridLayout& grid, int row) {
    m_otherCamera = new QCheckBox(tr("Its camera"), this);
    m_otherCamera->setObjectName("otherCamera");
    m_otherCamera->setToolTip(tr("Give the second view another camera than the first"));
    m_cameraB = new CameraBox(this);
    m_cameraB->setObjectName("cameraB");
    m_cameraB->setAccessibleName(tr("Camera of view %1").arg(tr("B")));
    grid.addWidget(m_otherCamera, row, 0);
    grid.addWidget(m_cameraB, row, 1, 1, 2);
    connect(m_otherCamera, &QCheckBox::toggled, this, &PreviewMode::applySides);
    connect(m_cameraB, &CameraBox::cameraChanged, this, &PreviewMode::applySides);
    connect(m_cameraB, &CameraBox::message, this, &Mode::message);
}

/// Makes what can be laid into the view or beside it.
void PreviewMode::makeOverlays(QGridLayout& grid, int row) {
    auto* objects = new ObjectFields(*m_presenter, this);
    auto* label = new QLabel(ObjectFields::tr("O&bject"), this);
    label->setBuddy(objects);
    grid.addWidget(label, row, 0);
    grid.addWidget(objects, row, 1, 1, 2);
    auto* error = new QCheckBox(tr("Sh&ow the expected error"), this);
    error->setObjectName("showError");
    error->setToolTip(tr("Tints what is displaced: light from half a pixel on, dark at %1 pixels and more")
                          .arg(kWorstShownPx));
    connect(error, &QCheckBox::toggled, m_presenter, &PreviewPresenter::setShowsError);
    grid.addWidget(error, row + 1, 0, 1, 3);
    m_own = new QPushButton(tr("The robot's own pictures..."), this);
    m_own->setObjectName("robotPictures");
    m_own->setToolTip(
        tr("Show what the robot's camera took beside the view: a CSV file with the columns file, x_m, y_m, "
           "z_m, qw, qx, qy, qz"));
    connect(m_own, &QPushButton::clicked, this, &PreviewMode::chooseRobotPictures);
    grid.addWidget(m_own, row + 2, 0, 1, 3);
}

void PreviewMode::chooseDataset() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a dataset"));
    if (!folder.isEmpty()) {
        m_presenter->openDataset(folder);
    }
}

void PreviewMode::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder for the frames"));
    if (!folder.isEmpty()) {
        m_presenter->saveFrames(folder);
    }
}

void PreviewMode::chooseRobotPictures() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Poses of the robot's own pictures"), {},
                                                      tr("Positions (*.csv)"));
    if (!file.isEmpty()) {
        m_presenter->openRobotPictures(file);
    }
}

void PreviewMode::applyMount() {
    m_presenter->setMount({m_height->value(), Degrees(m_pitch->value())});
}

void PreviewMode::applySides() {
    if (m_cameraB == nullptr) {
        return; // still being made
    }
    const bool isSplit = m_split->isChecked();
    m_otherCamera->setEnabled(isSplit);
    m_cameraB->setEnabled(isSplit && m_otherCamera->isChecked());
    m_sides[1].scene->setEnabled(isSplit);
    m_sides[1].sampling->setEnabled(isSplit);
    std::vector<ViewSide> sides;
    for (std::size_t i = 0; i < (isSplit ? 2U : 1U); ++i) {
        ViewSide side;
        const int scene = m_sides[i].scene->currentData().toInt();
        if (scene != kBestScene) {
            side.scene = static_cast<render::SceneKind>(scene);
        }
        side.sampling = static_cast<render::Sampling>(m_sides[i].sampling->currentData().toInt());
        sides.push_back(side);
    }
    if (isSplit && m_otherCamera->isChecked()) {
        sides.back().camera = m_cameraB->camera();
    }
    m_presenter->setSides(sides);
}

void PreviewMode::placeRobot(const QPointF& pInRoom, Qt::KeyboardModifiers modifiers) {
    const Eigen::Vector2d place(pInRoom.x(), pInRoom.y());
    if (const auto& object = m_presenter->objects().object();
        object && modifiers.testFlag(Qt::ShiftModifier)) {
        return m_presenter->objects().moveBy(place - object->footM.head<2>());
    }
    m_presenter->setRobot({place, m_presenter->robot().yaw});
    m_view->setFocus();
}

void PreviewMode::aimRobot(const QPointF& pInRoom, Qt::KeyboardModifiers modifiers) {
    if (modifiers.testFlag(Qt::ShiftModifier) && m_presenter->objects().object()) {
        return placeRobot(pInRoom, modifiers);
    }
    RobotPlace robot = m_presenter->robot();
    const Eigen::Vector2d towards = Eigen::Vector2d(pInRoom.x(), pInRoom.y()) - robot.pInRoom;
    if (towards.norm() > kLeastAimM) {
        robot.yaw = Radians(std::atan2(towards.y(), towards.x()));
        m_presenter->setRobot(robot);
    }
}

void PreviewMode::showDataset() {
    const render::Dataset* dataset = m_presenter->dataset();
    m_make->setEnabled(m_presenter->canMakeDataset());
    m_record->setEnabled(dataset != nullptr);
    m_own->setEnabled(dataset != nullptr);
    showRungs();
    takeMeasured();
    if (dataset == nullptr) {
        const SurveySession* session = m_presenter->session();
        const bool hasPhoto = session == nullptr || session->state().counts.stationsWithPhoto > 0;
        m_what->tell(
            m_presenter->isPreparing() ? Told(tr("Preparing the preview..."))
            : hasPhoto
                ? Told(session == nullptr ? tr("No dataset is open.") : tr("Nothing is previewed yet."))
                : Told(PreviewPresenter::tr("There is no photo to preview yet; capture or import "
                                            "some first."),
                       Cure::Capture));
        return;
    }
    const render::DatasetInfo& info = dataset->info();
    const bool isOutdated = m_presenter->isOutdated();
    const QString name = QString::fromStdString(info.name);
    const auto photos = static_cast<int>(info.photos.size());
    const std::vector<render::SceneKind> scenes = render::scenesOf(info);
    const bool hasDepth = std::find(scenes.begin(), scenes.end(), render::SceneKind::Depth) != scenes.end();
    const SurveySession* session = m_presenter->session();
    const bool isOurs = session != nullptr && session->store().info().uuid == info.surveyId;
    m_what->tell(
        isOutdated ? Told(tr("%1: the survey has changed since; preview it again.").arg(name))
        : m_presenter->isDeepening() ? Told(tr("%1: a sphere stands for the room; depth follows.").arg(name))
        : hasDepth || !isOurs
            ? Told(tr("%1: %n photo(s)", nullptr, photos).arg(name))
            : Told(tr("%1: %n photo(s), without depth.", nullptr, photos).arg(name), Cure::ExportDepth));
    const QSignalBlocker blocker(m_height);
    m_height->setValue(m_presenter->mount().heightM);
}

/// Takes the sampling that was measured to be enough, when a dataset with such a choice is opened.
void PreviewMode::takeMeasured() {
    const render::Dataset* dataset = m_presenter->dataset();
    if (std::exchange(m_shownDataset, dataset) == dataset || dataset == nullptr) {
        return;
    }
    const auto& choice = dataset->info().choice;
    if (choice && choice->isFor(m_presenter->camera())) {
        QComboBox* sampling = m_sides.front().sampling;
        sampling->setCurrentIndex(sampling->findData(static_cast<int>(render::Sampling::Auto)));
    }
}

/// Offers the scene models of the dataset, and names the ones that it would choose.
void PreviewMode::showRungs() {
    const render::Dataset* dataset = m_presenter->dataset();
    const render::DatasetInfo* info = dataset != nullptr ? &dataset->info() : nullptr;
    const auto isThere = [&](render::SceneKind scene) {
        const std::vector<render::SceneKind> there = render::scenesOf(*info);
        return std::find(there.begin(), there.end(), scene) != there.end();
    };
    for (const SideChoice& side : m_sides) {
        side.scene->setItemText(0, autoSceneWords(info, m_presenter->camera()));
        side.sampling->setItemText(side.sampling->findData(static_cast<int>(render::Sampling::Auto)),
                                   autoSamplingWords(info, m_presenter->camera()));
        for (int i = 1; i < side.scene->count(); ++i) {
            const auto scene = static_cast<render::SceneKind>(side.scene->itemData(i).toInt());
            const bool canBe = info == nullptr || isThere(scene);
            qobject_cast<QStandardItemModel*>(side.scene->model())->item(i)->setEnabled(canBe);
            if (!canBe && side.scene->currentIndex() == i) {
                side.scene->setCurrentIndex(0);
            }
        }
    }
}

void PreviewMode::showViews() {
    const double rate = m_presenter->rate();
    m_rate->setText(rate > 1 ? tr("%1 views/s").arg(rate, 0, 'f', 0) : QString());
}

void PreviewMode::showRecording() {
    const QSignalBlocker blocker(m_record);
    m_record->setChecked(m_presenter->isRecording());
    const auto frames = static_cast<int>(m_presenter->path().size());
    m_record->setText(m_presenter->isRecording() ? tr("● %n pose(s)", nullptr, frames) : tr("&Record"));
    m_save->setEnabled(frames > 0 && !m_presenter->isRecording());
}

} // namespace spherewalk::ui
