#pragma once

#include <insonate/image/Volume.h>
#include <insonate/ui/Commands.h>

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

/// Mouse input in slices while the current step of the guide needs points. A click adds a point, dragging moves a
/// point, the right button or the Delete key removes a point, and Enter continues. During a correction the left button
/// paints the label, and with Ctrl erases the label. All other events go to the slice.
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
  void addKeys();
  Vec3 patientAt(const Watched& where, QPoint at) const;
  std::optional<std::size_t> clickAt(const Watched& where, QPoint at) const;

  GuideSession& guide_;
  PrepareModel& shared_;
  ui::Commands keys_;  ///< keys on a slice for the current step
  std::vector<Watched> watched_;
  std::optional<std::size_t> dragged_;
  std::optional<QPoint> pressed_;
  bool painting_ = false;
  bool added_ = false;  ///< true: the last click has added a point
};

}  // namespace insonate::prepare
