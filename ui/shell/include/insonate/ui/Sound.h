#pragma once

#include <insonate/ui/SoundMixer.h>

#include <QObject>
#include <QPointer>
#include <QString>
#include <memory>
#include <span>

class QThread;

namespace insonate::ui {

/// The sound of the window: off at first, and remembered in the user's settings. While it is on, the default sound
/// device plays what the features add to mixer(). The device belongs to a thread of its own, so that it never delays
/// the window. Without a sound device nothing is heard, and problem() says so.
class Sound : public QObject {
  Q_OBJECT

 public:
  explicit Sound(QObject* parent = nullptr);
  ~Sound() override;

  bool isOn() const { return on_; }
  void setOn(bool isOn);
  /// Returns a sentence that says why nothing is heard although the sound is on; empty if there is no reason.
  QString problem() const { return problem_; }

  /// Adds a short sound, for example a beep, while the sound is on; see SoundMixer::play().
  void play(std::span<const float> samples);
  /// Opens a continuous sound; see SoundMixer::openStream(). A source need not compute samples while isOn() is false.
  std::shared_ptr<SoundStream> openStream() { return mixer_->openStream(); }

 Q_SIGNALS:
  void changed();  ///< emitted when isOn() or problem() has changed

 private:
  void openDevice();
  void closeDevice();
  void setProblem(const QString& problem);

  std::shared_ptr<SoundMixer> mixer_ = std::make_shared<SoundMixer>();
  QPointer<QThread> thread_;  ///< thread of the device; null: no device is open
  bool on_ = false;
  QString problem_;
};

}  // namespace insonate::ui
