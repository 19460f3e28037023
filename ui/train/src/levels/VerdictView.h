#pragma once

#include <QWidget>

class QLabel;

namespace insonate::train {

struct Verdict;

/// The verdict after an attempt: whether it passed its level, standards met and missed, and changes in the path.
class VerdictView final : public QWidget {
 public:
  explicit VerdictView(QWidget* parent = nullptr);

  void show(const Verdict& verdict);
  /// An attempt for no level.
  void show(const QString& sentence);

 private:
  QLabel *headline_, *standards_, *changes_;
};

}  // namespace insonate::train
