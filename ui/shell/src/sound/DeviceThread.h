#pragma once

#include <insonate/ui/SoundMixer.h>

#include <QThread>
#include <memory>
#include <utility>

namespace insonate::ui {

/// Thread that owns the sound device while its event loop runs. Opening a device can take seconds, for example with a
/// sound server that does not answer.
class DeviceThread : public QThread {
  Q_OBJECT

 public:
  explicit DeviceThread(std::shared_ptr<SoundMixer> mixer) : mixer_(std::move(mixer)) {}

 Q_SIGNALS:
  /// Emitted on this thread, which then ends; `problem` is a sentence for the user.
  void deviceFailed(const QString& problem);

 protected:
  void run() override;

 private:
  std::shared_ptr<SoundMixer> mixer_;
};

}  // namespace insonate::ui
