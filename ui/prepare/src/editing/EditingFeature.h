#pragma once

#include "../feature/Feature.h"

class QAction;

namespace insonate::prepare {

/// The feature for undo, redo and saving.
class EditingFeature final : public Feature {
 public:
  EditingFeature(PrepareModel& model, PrepareLayout& layout);

 private:
  void makeUndo();
  void makeSave();
  void refreshSave();

  QAction *undo_ = nullptr, *redo_ = nullptr, *save_ = nullptr;
};

}  // namespace insonate::prepare
