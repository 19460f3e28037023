#pragma once

#include <insonate/views/Input.h>

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <atomic>
#include <functional>
#include <mutex>

class vtkRenderWindow;

namespace insonate::views {

class DrawingThread;

/// Base of all views: a renderer in a window that the caller provides. One view to a window. For the window's thread
/// only, except for its frames if a DrawingThread makes them. Setters are cheap: their effects are computed when the
/// view is rendered next.
class View {
 public:
  View();
  virtual ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  /// Adds the view's renderers to the window; a view is in one window at most.
  void attach(vtkRenderWindow* window);
  void detach();

  /// The window's size in device pixels, and device pixels to a logical one (text and margins grow by it). Call it
  /// when the window has that size.
  void resize(int width_px, int height_px, double scale = 1);
  int width_px() const { return width_px_; }
  int height_px() const { return height_px_; }

  /// Renders the window now; where a DrawingThread does that, waits for it. Nothing happens without a window.
  void render();
  /// Waits until what was rendered is there: graphics go on behind the caller's back.
  void finish();
  /// Tells whether a DrawingThread can draw it.
  virtual bool canDrawOnThread() const { return false; }
  /// Has a DrawingThread come behind the window's: where other views are what one looks at. Before it is first drawn.
  void lowerThreadPriority() { behind_ = true; }
  bool hasLowerPriority() const { return behind_; }

  /// Called when the view wants to be rendered again; called often, so collect before rendering.
  void setRenderWanted(std::function<void()> listener) { renderWanted_ = std::move(listener); }
  /// For changes that views see by themselves, e.g. of what they share.
  void wantRender() const;
  /// Called on other threads when they have made something that is to be rendered: pass it on to the window's thread.
  /// After this returns, the listener before is not called any more.
  void setWake(std::function<void()> listener);

  /// Input; true when the view made use of it.
  virtual bool pressed(const Pointer&) { return false; }
  virtual bool moved(const Pointer&) { return false; }
  virtual bool released(const Pointer&) { return false; }
  /// Positive notches are away from the user; fractions come from touch pads.
  virtual bool wheel(const Pointer&, double /*notches*/) { return false; }
  virtual bool key(Key) { return false; }
  /// For a moment there was no wheel and no key: what was drawn coarser for them may be exact again.
  virtual void rested() {}

  vtkRenderer* renderer() { return renderer_; }

 protected:
  /// Brings what is drawn up to date. Called at the start of a rendering after changed() or resize().
  virtual void layout() = 0;
  /// True when something shared with other views has changed since the last layout.
  virtual bool outOfDate() const { return false; }
  virtual void attached(vtkRenderWindow&) {}
  virtual void detached(vtkRenderWindow&) {}

  /// An image comes about in three steps: the window's thread hands over what is to be seen, whoever draws takes it,
  /// and draws. The first two are never at work at once; the last may be while the view is told other things.
  virtual void handOver() {}
  virtual void takeOver() {}
  virtual void draw();
  void changed();
  double scale() const { return scale_; }
  vtkRenderWindow* window();
  /// From any thread.
  void wake();

 private:
  friend class DrawingThread;
  void rendererStarts();

  vtkNew<vtkRenderer> renderer_;
  vtkSmartPointer<vtkRenderWindow> window_;
  bool behind_ = false;
  std::function<void()> renderWanted_;
  std::mutex waking_;
  std::function<void()> wake_;  ///< guarded by the mutex
  int width_px_ = 1, height_px_ = 1;
  double scale_ = 1;
  std::atomic<bool> stale_{true};
  std::function<void()> renderElsewhere_;  ///< set while a DrawingThread draws
};

}  // namespace insonate::views
