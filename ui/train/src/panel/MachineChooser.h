#pragma once

#include <QComboBox>

namespace insonate::train {

class TrainSession;

/// The class of machines whose settings the image has; choosing one takes them. Shows none once a setting that the
/// machine decides is another.
class MachineChooser : public QComboBox {
 public:
  explicit MachineChooser(TrainSession& session, QWidget* parent = nullptr);

 private:
  void showCurrent();

  TrainSession& session_;
};

}  // namespace insonate::train
