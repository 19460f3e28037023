#pragma once

#include <QWidget>

class QLabel;

namespace insonate::train {

struct Verdict;

/// After an attempt: whether it passed its level, which standards were met or missed, what it changed in the path.
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
