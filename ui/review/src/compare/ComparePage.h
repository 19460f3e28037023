#pragma once

#include "../class/ClassReading.h"

#include <QWidget>
#include <optional>

class QComboBox;
class QLabel;

namespace insonate::ui {
class Chart;
}

namespace insonate::review {

class ClassDesk;

/// The class beside another one, in one metric.
class ComparePage final : public QWidget {
  Q_OBJECT

 public:
  explicit ComparePage(const ClassDesk& desk, QWidget* parent = nullptr);

 Q_SIGNALS:
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 private:
  void fillClasses();
  void readOther();
  void show();

  const ClassDesk& desk_;
  QLabel *own_, *words_;
  QComboBox *other_, *metric_;
  ui::Chart* chart_;
  std::optional<ClassFacts> otherFacts_;
  int round_ = 0;  ///< answers to earlier questions are not shown
};

}  // namespace insonate::review
