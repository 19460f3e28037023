#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

class QWidget;

namespace insonate::ui {

/// Rank of an input handler of a canvas. Events go to the handlers in this order, until one consumes the event; what
/// none consumes goes to the view itself. Within a rank, the handler that was added first comes first.
enum class InputRank {
  Observer,  ///< looks at events and consumes none, e.g. the pointer that is shown in other views
  Handle,    ///< drags a handle that is drawn on the image, e.g. of the field of view
  Tool,      ///< a tool that the user has selected
  Guide,     ///< clicks that a step of the guide has asked for
  Pointer,   ///< mouse and wheel on the image: probe, needle, measurements
  Commands,  ///< keys of the workspace's commands
};

/// The input handlers of one canvas, i.e. of the widget that receives a view's events. It is the canvas's only event
/// filter, and its child. For the window's thread only.
class CanvasInput : public QObject {
  Q_OBJECT

 public:
  /// The handlers of this canvas; made at the first call.
  static CanvasInput& of(QWidget& canvas);

  /// Adds a handler, whose eventFilter() is called with the canvas and an event and returns whether it has consumed the
  /// event. No effect if it is already added. A deleted handler is removed.
  void add(InputRank rank, QObject& handler);
  void remove(QObject& handler);

  bool eventFilter(QObject* canvas, QEvent* event) override;

 private:
  struct Entry {
    InputRank rank;
    QPointer<QObject> handler;
  };

  explicit CanvasInput(QWidget& canvas);

  std::vector<Entry> entries_;  ///< sorted by rank
};

}  // namespace insonate::ui
