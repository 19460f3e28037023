#pragma once

#include "ScrollingColumn.h"

class QVBoxLayout;

namespace insonate::train {

/// The narrow column of controls, in sections; a footer below them does not scroll.
class ControlsColumn : public ScrollingColumn {
 public:
  explicit ControlsColumn(QWidget* parent = nullptr);

  /// Adds a section below the others.
  void addSection(QWidget* section);
  void setFoot(QWidget* foot);

 private:
  QWidget* inner_;
  QVBoxLayout *sections_, *foot_;
};

}  // namespace insonate::train
