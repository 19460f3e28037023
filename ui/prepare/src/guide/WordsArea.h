#pragma once

#include <QScrollArea>

namespace insonate::prepare {

/// As high as its content wants to be at its width, and scrolled where the column is too low for that.
class WordsArea : public QScrollArea {
 public:
  explicit WordsArea(QWidget* content);

  QSize sizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace insonate::prepare
