// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/drive_view.h"

#include "ui/fields/scene_fields.h"
#include "ui/look/theme.h"
#include "ui/look/words.h"
#include "ui/map/station_words.h"
#include "ui/preview/preview_presenter.h"

#include <QFileInfo>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace spherewalk::ui {

namespace {

/// Returns the angle of a drag across the whole picture.
Radians dragAngle(const CameraIntrinsics& camera) {
    return Radians(2 * std::atan2(0.5 * camera.width, camera.fx));
}

std::vector<StationMark> marksOf(const render::DatasetInfo& info) {
    std::vector<StationMark> marks;
    for (std::size_t i = 0; i < info.photos.size(); ++i) {
        const render::DatasetPhoto& photo = info.photos[i];
        marks.push_back({static_cast<std::int64_t>(i), photo.roomFromPhoto.translation.head<2>(),
                         stationWords(photo.station), Standing::Taken});
        marks.back().note = QString::fromStdString(photo.file);
    }
    return marks;
}

Radians fieldOf(const CameraIntrinsics& camera) {
    const CameraModel model(camera);
    const double y = 0.5 * (camera.height - 1);
    const auto left = model.ray(Eigen::Vector2d(0, y));
    const auto right = model.ray(Eigen::Vector2d(camera.width - 1, y));
    return left && right ? Radians(std::atan2(right->x(), right->z()) - std::atan2(left->x(), left->z()))
                         : Radians(Degrees(180));
}

constexpr double kBodyPx = 11;
constexpr double kFanPx = 90;
const QColor kPath(204, 121, 167);

} // namespace

DriveView::DriveView(PreviewPresenter& presenter, QWidget* parent) : QWidget(parent), m_presenter(presenter) {
    setFocusPolicy(Qt::StrongFocus);
    announceAs(*this, QAccessible::Graphic, tr("What the robot's camera sees"));
    setMinimumSize(320, 240);
    setToolTip(
        tr("W A S D or the arrow keys drive, Q and E go sideways; drag to turn. Shift and a click put the "
           "object there."));
    connect(&presenter, &PreviewPresenter::viewsChanged, this, qOverload<>(&QWidget::update));
}

QString DriveView::errorText(const render::ViewReport& report) {
    if (report.isOutside) {
        return tr("outside of what was scanned");
    }
    if (!report.seesPlace) {
        return tr("no photo sees this place");
    }
    if (!(report.trust > 0)) {
        return tr("error not known");
    }
    const double errorPx = report.parallaxPx + report.blurPx;
    return tr("expected error %L1 px").arg(errorPx, 0, 'f', errorPx < 10 ? 1 : 0);
}

QString DriveView::reportText(const render::ViewReport& report, double share) {
    const QString photo = QFileInfo(QString::fromStdString(report.file)).fileName();
    QString text = tr("%1, %L2 cm away, %3, %L4 ms")
                       .arg(photo)
                       .arg(100 * report.offsetM, 0, 'f', 1)
                       .arg(errorText(report))
                       .arg(report.renderMs + report.decodeMs, 0, 'f', 1);
    text += QStringLiteral("\n") +
            tr("scene model %1, sampling %2").arg(sceneWord(report.scene), samplingWord(report.sampling));
    if (report.origin == render::ViewOrigin::Thumbnail) {
        text += tr(", coarse until it is decoded");
    } else if (report.origin == render::ViewOrigin::PreviousPhoto) {
        text += tr(", from the photo before until it is decoded");
    }
    if (share < 1) {
        text += tr(", %1 % of the size while it drives").arg(100 * share, 0, 'f', 0);
    }
    return text;
}

void DriveView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), QColor(24, 24, 24));
    const std::vector<MadeView>& views = m_presenter.views();
    if (views.empty()) {
        painter.setPen(QColor(200, 200, 200));
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                         m_presenter.dataset() != nullptr
                             ? tr("Rendering...")
                             : tr("Make a preview of the open survey, or open a dataset."));
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        paintView(painter, boxOf(i), views[i]);
    }
    if (m_presenter.showsError() && !views.empty()) {
        paintErrorLegend(painter);
    }
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
        painter.drawRect(rect().adjusted(1, 1, -1, -1));
    }
}

/// Returns the box of a view. Views lie side by side or stacked, whichever is larger.
QRect DriveView::boxOf(std::size_t view) const {
    const auto count = static_cast<int>(m_presenter.views().size());
    const auto index = static_cast<int>(view);
    const QSize picture = m_presenter.views().front().picture.size();
    const QSize beside(width() / count, height());
    const QSize above(width(), height() / count);
    const bool isBeside = picture.scaled(beside, Qt::KeepAspectRatio).width() >=
                          picture.scaled(above, Qt::KeepAspectRatio).width();
    const QRect box = isBeside ? QRect(QPoint(index * beside.width(), 0), beside)
                               : QRect(QPoint(0, index * above.height()), above);
    return box.adjusted(1, 1, -1, -1);
}

void DriveView::paintView(QPainter& painter, const QRect& box, const MadeView& view) {
    QRect target(QPoint(), view.picture.size().scaled(box.size(), Qt::KeepAspectRatio));
    target.moveCenter(box.center());
    painter.drawImage(target, view.picture);
    if (!view.caption.isEmpty()) {
        paintPlate(painter, target, Qt::AlignLeft | Qt::AlignBottom,
                   tr("The robot's own picture: %1").arg(view.caption));
        return;
    }
    const QRectF plate =
        paintPlate(painter, target, Qt::AlignLeft | Qt::AlignBottom, reportText(view.report, view.share));
    // How far the view can be believed, as a bar besides the number.
    const QRectF bar(plate.left(), plate.top() - 9, 120, 5);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0, 0, 0, 170));
    painter.drawRect(bar);
    painter.setBrush(QColor(86, 180, 233));
    painter.drawRect(QRectF(bar.topLeft(), QSizeF(bar.width() * view.report.trust, bar.height())));
}

/// Says what the tints of tintByError() mean.
void DriveView::paintErrorLegend(QPainter& painter) const {
    constexpr int kBarPx = 12;
    const QString words = tr("expected error: 0 to %1 px and more").arg(kWorstShownPx);
    const QRectF area = rect().adjusted(0, 0, 0, -height() / 2);
    const QRectF plate = paintPlate(painter, area, Qt::AlignTop | Qt::AlignRight, words);
    if (plate.isEmpty()) {
        return;
    }
    const QRectF bar(plate.left(), plate.bottom() + 2, plate.width(), kBarPx);
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    constexpr int kStops = 8;
    for (int i = 0; i <= kStops; ++i) {
        const double at = static_cast<double>(i) / kStops;
        gradient.setColorAt(at, PlanView::heatColour(at));
    }
    painter.fillRect(bar, gradient);
}

bool DriveView::isDriving(int key) {
    static const QSet<int> kKeys{Qt::Key_W, Qt::Key_A,    Qt::Key_S,     Qt::Key_D,  Qt::Key_Q,
                                 Qt::Key_E, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    return kKeys.contains(key);
}

DriveWish DriveView::wish() const {
    const auto held = [&](int a, int b) { return m_held.contains(a) || m_held.contains(b) ? 1 : 0; };
    DriveWish wish;
    wish.forward = held(Qt::Key_W, Qt::Key_Up) - held(Qt::Key_S, Qt::Key_Down);
    wish.turnLeft = held(Qt::Key_A, Qt::Key_Left) - held(Qt::Key_D, Qt::Key_Right);
    wish.left = held(Qt::Key_Q, Qt::Key_Q) - held(Qt::Key_E, Qt::Key_E);
    return wish;
}

void DriveView::keyPressEvent(QKeyEvent* event) {
    if (changeObject(*event)) {
        return;
    }
    if (!isDriving(event->key()) || event->modifiers().testFlag(Qt::ControlModifier)) {
        return QWidget::keyPressEvent(event);
    }
    if (!event->isAutoRepeat()) {
        m_held.insert(event->key());
        m_presenter.drive(wish());
    }
}

void DriveView::keyReleaseEvent(QKeyEvent* event) {
    if (!isDriving(event->key())) {
        return QWidget::keyReleaseEvent(event);
    }
    if (!event->isAutoRepeat()) {
        m_held.remove(event->key());
        m_presenter.drive(wish());
    }
}

void DriveView::focusOutEvent(QFocusEvent* event) {
    m_held.clear(); // their releases go elsewhere
    m_presenter.drive({});
    QWidget::focusOutEvent(event);
    update();
}

/// Does what a key means for the object in the view. Returns false for any other key.
bool DriveView::changeObject(const QKeyEvent& event) {
    constexpr double kGrows = 1.1;
    constexpr Degrees kTurn{15};
    constexpr double kStepM = 0.05;
    ObjectStage& objects = m_presenter.objects();
    const auto& object = objects.object();
    if (event.modifiers().testFlag(Qt::ControlModifier) || event.modifiers().testFlag(Qt::AltModifier)) {
        return false;
    }
    if (event.modifiers().testFlag(Qt::ShiftModifier) && isDriving(event.key()) && object) {
        const Radians yaw = m_presenter.robot().yaw;
        const Eigen::Vector2d ahead(cos(yaw), sin(yaw));
        const Eigen::Vector2d left(-ahead.y(), ahead.x());
        switch (event.key()) {
        case Qt::Key_Up:
            objects.moveBy(kStepM * ahead);
            return true;
        case Qt::Key_Down:
            objects.moveBy(-kStepM * ahead);
            return true;
        case Qt::Key_Left:
            objects.moveBy(kStepM * left);
            return true;
        case Qt::Key_Right:
            objects.moveBy(-kStepM * left);
            return true;
        default:
            return false;
        }
    }
    switch (event.key()) {
    case Qt::Key_O:
        objects.toggle(m_presenter.beforeRobot());
        return true;
    case Qt::Key_Plus:
    case Qt::Key_Equal: // the key of + without Shift
        objects.setSize(object ? kGrows * object->sizeM : 0);
        return true;
    case Qt::Key_Minus:
        objects.setSize(object ? object->sizeM / kGrows : 0);
        return true;
    case Qt::Key_Comma:
        objects.turn(kTurn);
        return true;
    case Qt::Key_Period:
        objects.turn(-Radians(kTurn));
        return true;
    default:
        return false;
    }
}

QList<Mode::Key> DriveView::keys() {
    return {{QStringLiteral("W A S D, Q E"), tr("Drive")},
            {QStringLiteral("O"), tr("Lay the object, or take it away")},
            {QStringLiteral("+ -"), tr("Make the object larger or smaller")},
            {QStringLiteral(", ."), tr("Turn the object")},
            {tr("Shift and the arrow keys"), tr("Move the object")},
            {tr("Shift and a click"), tr("Stand the object on the surface there")}};
}

/// The pixel of the robot's camera under this place of the first view, or nothing beside the view.
std::optional<Eigen::Vector2d> DriveView::pixelAt(const QPointF& place) const {
    if (m_presenter.views().empty()) {
        return std::nullopt;
    }
    const MadeView& view = m_presenter.views().front();
    const QRect box = boxOf(0);
    QRectF target(QPointF(), QSizeF(view.picture.size().scaled(box.size(), Qt::KeepAspectRatio)));
    target.moveCenter(box.center());
    if (!target.contains(place)) {
        return std::nullopt;
    }
    const CameraIntrinsics& camera = m_presenter.camera();
    return Eigen::Vector2d((place.x() - target.left()) / target.width() * camera.width - 0.5,
                           (place.y() - target.top()) / target.height() * camera.height - 0.5);
}

void DriveView::mousePressEvent(QMouseEvent* event) {
    m_dragFrom = event->position();
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        if (const auto pixel = pixelAt(event->position())) {
            m_presenter.putObjectAt(*pixel);
        }
    }
}

void DriveView::mouseMoveEvent(QMouseEvent* event) {
    if (!event->buttons().testFlag(Qt::LeftButton) || event->modifiers().testFlag(Qt::ShiftModifier)) {
        return;
    }
    const QPointF moved = event->position() - m_dragFrom;
    m_dragFrom = event->position();
    RobotPlace robot = m_presenter.robot();
    const double share = moved.x() / std::max(1, width());
    robot.yaw = wrapped(robot.yaw + dragAngle(m_presenter.camera()) * share);
    m_presenter.setRobot(robot);
}

/// Draws the robot on its map.
class RobotMap::Layer : public PlanLayer {
  public:
    explicit Layer(const PreviewPresenter& presenter) : m_presenter(presenter) {}

    void paint(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    void paintPath(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintObject(QPainter& painter, const QTransform& widgetFromRoom) const;
    void paintRobot(QPainter& painter, const QPointF& at) const;

    const PreviewPresenter& m_presenter;
};

void RobotMap::Layer::paint(QPainter& painter, const QTransform& widgetFromRoom) {
    if (m_presenter.dataset() == nullptr) {
        return;
    }
    paintPath(painter, widgetFromRoom);
    paintObject(painter, widgetFromRoom);
    const QPointF at = mapped(m_presenter.robot().pInRoom, widgetFromRoom);
    if (!m_presenter.views().empty()) {
        const auto& photos = m_presenter.dataset()->info().photos;
        const render::DatasetPhoto& photo = photos.at(m_presenter.views().front().report.photo);
        painter.setPen(QPen(goodColour(), 1.5, Qt::DashLine));
        painter.drawLine(at, mapped(photo.roomFromPhoto.translation.head<2>(), widgetFromRoom));
    }
    paintRobot(painter, at);
}

void RobotMap::Layer::paintPath(QPainter& painter, const QTransform& widgetFromRoom) const {
    QPolygonF line;
    for (const TimedPose& pose : m_presenter.path()) {
        line << mapped(pose.roomFromCamera.translation.head<2>(), widgetFromRoom);
    }
    if (line.size() > 1) {
        painter.setPen(QPen(kPath, 2.5));
        painter.drawPolyline(line);
    }
}

void RobotMap::Layer::paintObject(QPainter& painter, const QTransform& widgetFromRoom) const {
    const auto& object = m_presenter.objects().object();
    if (!object) {
        return;
    }
    constexpr double kLeastPx = 8;
    const bool isBall = object->shape == LaidObject::Shape::Ball;
    const auto& colour = isBall ? jobs::Ball().colour : jobs::PlacedMesh().colour;
    const double scale = std::hypot(widgetFromRoom.m11(), widgetFromRoom.m12());
    const Eigen::Vector3d sides = scale * object->sidesM();
    QRectF box(0, 0, std::max(kLeastPx, sides.x()), std::max(kLeastPx, sides.y()));
    box.moveCenter({0, 0});
    painter.save();
    painter.translate(mapped(object->footM.head<2>(), widgetFromRoom));
    painter.rotate(-Degrees(object->yaw).value());
    painter.setPen(QPen(QColor(colour[0], colour[1], colour[2]), 2));
    painter.setBrush(QColor(colour[0], colour[1], colour[2], 110));
    isBall ? painter.drawEllipse(box) : painter.drawRect(box);
    painter.restore();
}

void RobotMap::Layer::paintRobot(QPainter& painter, const QPointF& at) const {
    const QColor robotColour = goodColour();
    const double yawDeg = Degrees(m_presenter.robot().yaw).value();
    const double fovDeg = std::min(359.0, Degrees(fieldOf(m_presenter.camera())).value());
    QColor fan = robotColour;
    fan.setAlpha(60);
    painter.setPen(QPen(robotColour, 1));
    painter.setBrush(fan);
    painter.drawPie(QRectF(at.x() - kFanPx, at.y() - kFanPx, 2 * kFanPx, 2 * kFanPx),
                    static_cast<int>(16 * (yawDeg - 0.5 * fovDeg)), static_cast<int>(16 * fovDeg));
    painter.save();
    painter.translate(at);
    painter.rotate(-yawDeg);
    painter.setPen(QPen(Qt::white, 1.5));
    painter.setBrush(robotColour);
    painter.drawPolygon(QPolygonF({{kBodyPx, 0},
                                   {-0.7 * kBodyPx, 0.7 * kBodyPx},
                                   {-0.35 * kBodyPx, 0},
                                   {-0.7 * kBodyPx, -0.7 * kBodyPx}}));
    painter.restore();
}

RobotMap::RobotMap(const PreviewPresenter& presenter, QWidget* parent)
    : PlanView(parent), m_presenter(presenter), m_layer(std::make_unique<Layer>(presenter)) {
    addLayer(m_layer.get());
    connect(&presenter, &PreviewPresenter::datasetChanged, this, &RobotMap::showDataset);
    connect(&presenter, &PreviewPresenter::robotChanged, this, qOverload<>(&QWidget::update));
    connect(&presenter, &PreviewPresenter::viewsChanged, this, qOverload<>(&QWidget::update));
    showDataset();
}

RobotMap::~RobotMap() {
    removeLayer(m_layer.get());
}

QString RobotMap::emptyText() const {
    return m_presenter.session() != nullptr ? tr("Nothing is previewed yet") : tr("No dataset is open");
}

void RobotMap::showDataset() {
    if (m_presenter.dataset() == nullptr) {
        setRoom({});
        return setStations({});
    }
    const render::DatasetInfo& info = m_presenter.dataset()->info();
    setRoom({info.outline, info.obstacles, info.ceilingM});
    setStations(marksOf(info));
}

} // namespace spherewalk::ui
