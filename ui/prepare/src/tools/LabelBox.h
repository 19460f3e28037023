#pragma once

#include <QComboBox>

namespace insonate::prepare {

struct PrepareModel;

/// One of the case's structures, by name and colour.
class LabelBox : public QComboBox {
  Q_OBJECT

 public:
  LabelBox(PrepareModel& shared, const QString& name, const QString& hint);

  /// Shows a label; nothing where the case has none of it.
  void show(std::uint8_t label);

 Q_SIGNALS:
  /// The user chose a label.
  void chosen(std::uint8_t label);

 private:
  void fill();

  PrepareModel& shared_;
  std::uint8_t label_ = 0;
};

}  // namespace insonate::prepare
