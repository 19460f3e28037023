#pragma once

#include <QScrollArea>

namespace insonate::prepare {

/// Takes the height that its content needs at its width, and scrolls if the column is too low for that.
class WordsArea : public QScrollArea {
 public:
  explicit WordsArea(QWidget* content);

  QSize sizeHint() const override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
};

}  // namespace insonate::prepare
