// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;

namespace spherewalk::ui {

class PreviewPresenter;

/// Asks which object stands in the views of the preview, and how large it is.
class ObjectFields : public QWidget {
    Q_OBJECT

  public:
    explicit ObjectFields(PreviewPresenter& presenter, QWidget* parent = nullptr);

  private:
    void choose(int index);
    void showObject();

    PreviewPresenter& m_presenter;
    QComboBox* m_shape;
    QDoubleSpinBox* m_size;
};

} // namespace spherewalk::ui
