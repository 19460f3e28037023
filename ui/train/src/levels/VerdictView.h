#pragma once

#include <QWidget>

class QLabel;

namespace insonate::train {

struct Verdict;

/// Shows the verdict on an attempt: passed or not, standards met and missed, and changes in the learning path.
class VerdictView final : public QWidget {
 public:
  explicit VerdictView(QWidget* parent = nullptr);

  void show(const Verdict& verdict);
  /// Shows a sentence in place of a verdict, for an attempt without a level.
  void show(const QString& sentence);

 private:
  QLabel *headline_, *standards_, *changes_;
};

}  // namespace insonate::train
