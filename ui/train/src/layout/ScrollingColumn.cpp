#include "ScrollingColumn.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace insonate::train {

void ScrollingColumn::setParts(QWidget* scrolled, QWidget* foot) {
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(scrolled);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(scroll, 1);
  column->addWidget(foot);
}

}  // namespace insonate::train
