// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/preview/object_fields.h"

#include "ui/preview/preview_presenter.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QSignalBlocker>

namespace spherewalk::ui {

using Shape = LaidObject::Shape;

ObjectFields::ObjectFields(PreviewPresenter& presenter, QWidget* parent)
    : QWidget(parent),
      m_presenter(presenter),
      m_shape(new QComboBox(this)),
      m_size(new QDoubleSpinBox(this)) {
    m_shape->setObjectName("object");
    m_shape->setAccessibleName(tr("Object in the view"));
    m_shape->setToolTip(tr(
        "An object as a simulator would render it. With Shift, click in the view to stand it on the surface "
        "there, or on the plan. O lays it or takes it away, + and - change its size, comma and period turn "
        "it, "
        "and the arrow keys with Shift move it."));
    m_shape->addItem(tr("Nothing"));
    m_shape->addItem(tr("Ball"), static_cast<int>(Shape::Ball));
    m_shape->addItem(tr("Box"), static_cast<int>(Shape::Box));
    m_shape->addItem(tr("Mesh (OBJ file)..."), static_cast<int>(Shape::Mesh));
    m_size->setObjectName("objectSize");
    m_size->setAccessibleName(tr("Size of the object"));
    m_size->setToolTip(tr("Its longest side"));
    m_size->setRange(LaidObject::kSmallestM, LaidObject::kLargestM);
    m_size->setSingleStep(0.05);
    m_size->setSuffix(tr(" m"));
    m_size->setValue(LaidObject().sizeM);
    setFocusProxy(m_shape);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(m_shape, 1);
    row->addWidget(m_size);
    connect(m_shape, &QComboBox::activated, this, &ObjectFields::choose);
    connect(m_size, &QDoubleSpinBox::valueChanged, &presenter.objects(), &ObjectStage::setSize);
    connect(&presenter.objects(), &ObjectStage::changed, this, &ObjectFields::showObject);
    showObject();
}

void ObjectFields::choose(int index) {
    const QVariant shape = m_shape->itemData(index);
    ObjectStage& objects = m_presenter.objects();
    if (shape.toInt() != static_cast<int>(Shape::Mesh) || !shape.isValid()) {
        return objects.lay(shape.isValid() ? std::optional(static_cast<Shape>(shape.toInt())) : std::nullopt,
                           m_presenter.beforeRobot());
    }
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Mesh with z up, in metres"), {}, tr("Meshes (*.obj)"));
    file.isEmpty() ? showObject() : objects.readMesh(file, m_presenter.beforeRobot());
}

void ObjectFields::showObject() {
    const auto& object = m_presenter.objects().object();
    m_shape->setCurrentIndex(object ? m_shape->findData(static_cast<int>(object->shape)) : 0);
    m_size->setEnabled(object.has_value());
    if (object) {
        const QSignalBlocker blocker(m_size);
        m_size->setValue(object->sizeM);
    }
}

} // namespace spherewalk::ui
