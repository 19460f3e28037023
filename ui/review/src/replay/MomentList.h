#pragma once

#include <QListWidget>

namespace insonate::review {

class ReviewSession;

/// The moments that mattered, with their marks of the timeline; a click goes there, and the last one that has passed is
/// the current one.
class MomentList : public QListWidget {
  Q_OBJECT

 public:
  explicit MomentList(ReviewSession& session, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Enter or a double click: its image is wanted, too.
  void entered();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fill();
  void fit();
  void follow();

  ReviewSession& session_;
};

}  // namespace insonate::review
