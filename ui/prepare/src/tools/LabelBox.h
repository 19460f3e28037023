#pragma once

#include <QComboBox>

namespace insonate::prepare {

struct PrepareModel;

/// Combo box of the case's structures, with name and color.
class LabelBox : public QComboBox {
  Q_OBJECT

 public:
  LabelBox(PrepareModel& shared, const QString& name, const QString& hint);

  /// Selects a label; no label if the case has no such structure.
  void show(std::uint8_t label);

 Q_SIGNALS:
  /// Emitted when the user has chosen a label.
  void chosen(std::uint8_t label);

 private:
  void listLabels();

  PrepareModel& shared_;
  std::uint8_t label_ = 0;
};

}  // namespace insonate::prepare
