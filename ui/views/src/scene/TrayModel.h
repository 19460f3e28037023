#pragma once

#include "NeedleModel.h"

#include <optional>

namespace insonate::views {

/// Model of a shallow steel tray with a needle on it.
class TrayModel {
 public:
  explicit TrayModel(vtkRenderer& renderer);
  ~TrayModel();

  void set(const std::optional<Transform>& patientFromTray);

 private:
  vtkRenderer& renderer_;
  vtkNew<vtkActor> dish_;
  NeedleModel needle_;
};

}  // namespace insonate::views
