// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/tour.h"

#include "ui/look/side_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>

namespace spherewalk::ui {

Tour::Tour(QWidget* parent)
    : QWidget(parent),
      m_steps{
          {"plan",
           tr("This is the plan of a practice room: walls, furniture, and rails with their stops. A ring "
              "is where a rail begins. The Sheet tells how to lay the rails with a tape.")},
          {"capture",
           tr("The practice camera now takes the photos by itself. With a real camera, bring it to the "
              "cross on the plan and press Space.")},
          {"review", tr("Look at the photos: J and K go from one to the next, A accepts, R rejects. What the "
                        "checks found is outlined in the photo. C compares with a neighbour.")},
          {"align",
           tr("Press Align. It solves how each photo is turned, and finds stations that were mixed up.")},
          {"preview",
           tr("Press Preview this survey, click into the view, and drive with W A S D. That is what a "
              "robot would see. Export writes it for simulators.")},
      },
      m_words(new QLabel(this)),
      m_back(new QPushButton(tr("Back"), this)),
      m_next(new QPushButton(this)) {
    setObjectName("tour");
    setAccessibleName(tr("Tour"));
    m_words->setObjectName("tourWords");
    m_words->setWordWrap(true);
    m_back->setObjectName("tourBack");
    m_next->setObjectName("tourNext");
    makePrimary(m_next);
    auto* end = new QPushButton(tr("End the tour"), this);
    end->setObjectName("tourEnd");
    auto* row = new QHBoxLayout(this);
    row->addWidget(m_words, 1);
    row->addWidget(m_back);
    row->addWidget(m_next);
    row->addWidget(end);
    connect(m_back, &QPushButton::clicked, this, [this] { show(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this,
            [this] { m_step + 1 < steps() ? show(m_step + 1) : this->end(); });
    connect(end, &QPushButton::clicked, this, &Tour::end);
    hide();
}

void Tour::begin() {
    show(0);
    setVisible(true);
}

void Tour::end() {
    hide();
}

void Tour::show(int step) {
    m_step = step;
    const Step& shown = m_steps[static_cast<std::size_t>(step)];
    m_words->setText(tr("<b>%1 of %2.</b> %3").arg(step + 1).arg(steps()).arg(shown.words));
    m_back->setEnabled(step > 0);
    m_next->setText(step + 1 < steps() ? tr("Next step") : tr("Done"));
    emit pageWanted(shown.page);
    if (shown.page == QLatin1String("capture")) {
        emit photosWanted();
    }
}

} // namespace spherewalk::ui
