#pragma once

#include <QObject>
#include <QPointer>
#include <vector>

class QWidget;

namespace insonate::ui {

/// Rank of an input handler of a canvas. An event goes to the handlers in the order of their ranks until one of them
/// consumes the event; if none does, the event goes to the view. Of handlers with the same rank, the one that was added
/// first comes first.
enum class InputRank {
  Observer,  ///< observes events and consumes none, e.g. to mark the pointer's position in other views
  Handle,    ///< drags a handle that is drawn on the image, e.g. of the field of view
  Tool,      ///< a tool that the user has selected
  Guide,     ///< clicks that a step of the guide has asked for
  Pointer,   ///< mouse and wheel on the image: probe, needle, measurements
  Commands,  ///< keys of the workspace's commands
};

/// The input handlers of one canvas, which is the widget that receives the events of a view. This object is a child of
/// the canvas, and the canvas's only event filter. May be used only on the window's thread.
class CanvasInput : public QObject {
  Q_OBJECT

 public:
  /// Returns the input handlers of a canvas; makes the object at the first call.
  static CanvasInput& of(QWidget& canvas);

  /// Adds a handler. Its eventFilter() is called with the canvas and the event, and returns true if it has consumed the
  /// event. Has no effect if the handler was already added. A handler that is deleted is removed.
  void add(InputRank rank, QObject& handler);
  void remove(QObject& handler);

  bool eventFilter(QObject* canvas, QEvent* event) override;

 private:
  struct Entry {
    InputRank rank;
    QPointer<QObject> handler;
  };

  explicit CanvasInput(QWidget& canvas);

  std::vector<Entry> entries_;  ///< handlers, sorted by rank
};

}  // namespace insonate::ui
