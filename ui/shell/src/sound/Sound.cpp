#include "DeviceThread.h"

#include <insonate/ui/Sound.h>

#include <QAudioDeviceInfo>
#include <QAudioOutput>
#include <QIODevice>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace insonate::ui {
namespace {

const QString kSetting = QStringLiteral("window/sound");
constexpr int kChannels = 2;
/// Short enough that a beep is heard with its heartbeat, long enough for a busy computer.
constexpr int kBuffer_ms = 60;

/// Source from which the device reads samples: the mixer's signal on both channels.
class MixedSamples : public QIODevice {
 public:
  explicit MixedSamples(std::shared_ptr<SoundMixer> mixer) : mixer_(std::move(mixer)) {
    // A buffer of Qt would hold 85 ms, longer than the lead of a stream.
    open(QIODevice::ReadOnly | QIODevice::Unbuffered);
  }

  bool isSequential() const override { return true; }
  qint64 bytesAvailable() const override {
    return kBuffer_ms * kSoundRate_Hz / 1000 * kFrame + QIODevice::bytesAvailable();
  }

 protected:
  qint64 readData(char* data, qint64 most) override {
    const auto frames = std::size_t(std::max<qint64>(most / kFrame, 0));
    mono_.resize(frames);
    mixer_->mix(mono_);
    auto* out = reinterpret_cast<qint16*>(data);
    for (std::size_t i = 0; i < frames; ++i) out[2 * i] = out[2 * i + 1] = qint16(std::lround(32767 * mono_[i]));
    return qint64(frames) * kFrame;
  }
  qint64 writeData(const char*, qint64) override { return -1; }

 private:
  static constexpr qint64 kFrame = kChannels * sizeof(qint16);

  std::shared_ptr<SoundMixer> mixer_;
  std::vector<float> mono_;
};

QAudioFormat formatOfSound() {
  QAudioFormat format;
  format.setSampleRate(kSoundRate_Hz);
  format.setChannelCount(kChannels);
  format.setSampleSize(16);
  format.setCodec(QStringLiteral("audio/pcm"));
  format.setByteOrder(QAudioFormat::Endian(QSysInfo::ByteOrder));
  format.setSampleType(QAudioFormat::SignedInt);
  return format;
}

}  // namespace

void DeviceThread::run() {
  const QAudioDeviceInfo device = QAudioDeviceInfo::defaultOutputDevice();
  const QAudioFormat format = formatOfSound();
  if (device.isNull()) return deviceFailed(Sound::tr("This computer has no sound device."));
  if (!device.isFormatSupported(format))
    return deviceFailed(Sound::tr("The sound device does not play stereo sound at 48 kHz."));
  MixedSamples samples(mixer_);
  QAudioOutput output(device, format);
  output.setBufferSize(kBuffer_ms * kSoundRate_Hz / 1000 * kChannels * int(sizeof(qint16)));
  output.start(&samples);
  if (output.error() == QAudio::OpenError) return deviceFailed(Sound::tr("The sound device could not be opened."));
  exec();
  output.stop();
}

Sound::Sound(QObject* parent) : QObject(parent), on_(QSettings().value(kSetting, false).toBool()) {
  if (on_) openDevice();
}

Sound::~Sound() {
  constexpr unsigned long kLongest_ms = 1000;
  closeDevice();
  if (thread_) thread_->wait(kLongest_ms);
}

void Sound::setOn(bool isOn) {
  if (isOn == on_) return;
  on_ = isOn;
  QSettings().setValue(kSetting, on_);
  problem_.clear();
  on_ ? openDevice() : closeDevice();
  Q_EMIT changed();
}

void Sound::play(std::span<const float> samples) {
  // Without a device nothing would ever remove the samples.
  if (on_ && problem_.isEmpty()) mixer_->play(samples);
}

void Sound::openDevice() {
  mixer_->clear();
  auto* device = new DeviceThread(mixer_);
  connect(device, &DeviceThread::deviceFailed, this, &Sound::setProblem);
  connect(device, &QThread::finished, device, &QObject::deleteLater);
  thread_ = device;
  thread_->start();
}

/// The window does not wait for the device.
void Sound::closeDevice() {
  if (!thread_) return;
  thread_->disconnect(this);
  thread_->quit();
}

void Sound::setProblem(const QString& problem) {
  if (!on_) return;
  problem_ = problem;
  Q_EMIT changed();
}

}  // namespace insonate::ui
