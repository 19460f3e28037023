#pragma once

#include <insonate/image/Volume.h>

#include <QObject>
#include <QPoint>
#include <optional>
#include <vector>

namespace insonate::ui {
class ViewWidget;
}
namespace insonate::views {
class MprView;
}

namespace insonate::prepare {

class GuideSession;
struct PrepareModel;

/// The mouse in slices while the guide wants clicks: a click adds a point, dragging moves it, the right button or the
/// Delete key removes it, Enter continues. While a label is corrected, the left button paints it, with Control erases.
/// All other events are the slice's own.
class GuidePointer : public QObject {
 public:
  GuidePointer(GuideSession& guide, PrepareModel& shared, QObject* parent);

  void watch(ui::ViewWidget& widget, views::MprView& slice);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  struct Watched {
    ui::ViewWidget* widget;
    views::MprView* slice;
  };
  bool press(const Watched& where, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers keys);
  bool move(const Watched& where, QPoint at);
  bool release(const Watched& where, QPoint at);
  bool doubleClick(Qt::MouseButton button);
  bool key(int key, bool act);
  Vec3 patientAt(const Watched& where, QPoint at) const;
  std::optional<std::size_t> clickAt(const Watched& where, QPoint at) const;

  GuideSession& guide_;
  PrepareModel& shared_;
  std::vector<Watched> watched_;
  std::optional<std::size_t> dragged_;
  std::optional<QPoint> pressed_;
  bool painting_ = false;
  bool added_ = false;  ///< a point, by the last click
};

}  // namespace insonate::prepare
