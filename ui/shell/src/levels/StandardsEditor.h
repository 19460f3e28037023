#pragma once

#include "LevelControls.h"

#include <insonate/curriculum/MetricMeaning.h>

#include <QWidget>
#include <vector>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

/// Editor of the passing standard of one attempt: points, metric standards, and the number of metric standards that
/// must be met. In any case an attempt must be completed and must succeed without a critical error.
class StandardsEditor final : public QWidget {
  Q_OBJECT

 public:
  explicit StandardsEditor(const std::vector<MetricMeaning>& metrics, QWidget* parent = nullptr);

  void show(const PassRule& rule);
  using QWidget::show;

 Q_SIGNALS:
  void edited(const QString& field, const insonate::ui::LevelEdit& change);

 private:
  QWidget* buildRule();
  QWidget* buildStandard();
  void add();
  void remove();
  void showStandard();
  /// Applies `what` to the selected standard.
  void change(const QString& field, const std::function<void(MetricStandard&)>& what);
  QString titleOf(const MetricStandard& standard) const;

  const std::vector<MetricMeaning>& metrics_;
  PassRule rule_;
  QCheckBox *points_, *critical_;
  QDoubleSpinBox *minPoints_, *percent_, *limit_;
  QTableWidget* table_;
  QComboBox *metric_, *bound_;
  QLineEdit* otherwise_;
  QPushButton *add_, *remove_;
};

}  // namespace insonate::ui
