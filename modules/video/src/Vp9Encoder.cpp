#include "Vp9Encoder.h"

#include <vpx/vp8cx.h>
#include <vpx/vpx_encoder.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace insonate::video {
namespace {

/// Speed of libvpx, 0 to 9. From 5 to 8 the time of a frame halves, and the file grows by a fifth.
constexpr int kSpeed = 7;

std::uint8_t byteOf(double value) {
  return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L));
}

/// Red, green and blue of one pixel; gray has the same three.
struct Rgb {
  double red, green, blue;
};

Rgb pixelOf(const VideoFrame& frame, int x, int y) {
  const std::uint8_t* at = frame.pixels.data() + (std::size_t(y) * frame.width + x) * frame.channels;
  if (frame.channels == 1) return {double(at[0]), double(at[0]), double(at[0])};
  return {double(at[0]), double(at[1]), double(at[2])};
}

/// Luma and chroma of ITU-R BT.709, limited range: 16..235 and 16..240.
constexpr double kRed = 0.2126, kGreen = 0.7152, kBlue = 0.0722;
double lumaOf(const Rgb& p) {
  return kRed * p.red + kGreen * p.green + kBlue * p.blue;
}

void convert(const VideoFrame& frame, vpx_image_t& image) {
  for (int y = 0; y < frame.height; ++y) {
    std::uint8_t* row = image.planes[VPX_PLANE_Y] + std::ptrdiff_t(y) * image.stride[VPX_PLANE_Y];
    for (int x = 0; x < frame.width; ++x) row[x] = byteOf(16 + lumaOf(pixelOf(frame, x, y)) * 219 / 255);
  }
  for (int y = 0; y < frame.height / 2; ++y) {
    std::uint8_t* u = image.planes[VPX_PLANE_U] + std::ptrdiff_t(y) * image.stride[VPX_PLANE_U];
    std::uint8_t* v = image.planes[VPX_PLANE_V] + std::ptrdiff_t(y) * image.stride[VPX_PLANE_V];
    for (int x = 0; x < frame.width / 2; ++x) {
      Rgb sum{0, 0, 0};
      for (int k = 0; k < 4; ++k) {
        const Rgb p = pixelOf(frame, 2 * x + k % 2, 2 * y + k / 2);
        sum.red += p.red / 4, sum.green += p.green / 4, sum.blue += p.blue / 4;
      }
      const double luma = lumaOf(sum);
      u[x] = byteOf(128 + (sum.blue - luma) / (2 * (1 - kBlue)) * 224 / 255);
      v[x] = byteOf(128 + (sum.red - luma) / (2 * (1 - kRed)) * 224 / 255);
    }
  }
}

}  // namespace

struct Vp9Encoder::State {
  State(int width, int height, Take takes) : take(std::move(takes)) {
    image = vpx_img_alloc(nullptr, VPX_IMG_FMT_I420, static_cast<unsigned>(width), static_cast<unsigned>(height), 16);
    if (!image) throw std::bad_alloc();
    image->cs = VPX_CS_BT_709, image->range = VPX_CR_STUDIO_RANGE;
  }
  ~State() {
    if (isReady) vpx_codec_destroy(&codec);
    vpx_img_free(image);
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Encodes `frame` (null: no more come) and passes on what is ready; tells whether something was.
  Result<bool> encode(const vpx_image_t* frame, std::int64_t time_ms, std::int64_t duration_ms) {
    if (vpx_codec_encode(&codec, frame, time_ms, static_cast<unsigned long>(duration_ms), 0, VPX_DL_GOOD_QUALITY) !=
        VPX_CODEC_OK)
      return fail("The video cannot be encoded: " + std::string(vpx_codec_error(&codec)) + ".");
    bool some = false;
    vpx_codec_iter_t place = nullptr;
    while (const vpx_codec_cx_pkt_t* packet = vpx_codec_get_cx_data(&codec, &place)) {
      if (packet->kind != VPX_CODEC_CX_FRAME_PKT) continue;
      some = true;
      const auto& data = packet->data.frame;
      take({static_cast<const std::uint8_t*>(data.buf), data.sz}, data.pts, (data.flags & VPX_FRAME_IS_KEY) != 0);
    }
    return some;
  }

  Take take;
  vpx_image_t* image = nullptr;
  vpx_codec_ctx_t codec{};
  bool isReady = false;
};

Vp9Encoder::Vp9Encoder(std::unique_ptr<State> state) : state_(std::move(state)) {}
Vp9Encoder::Vp9Encoder(Vp9Encoder&&) noexcept = default;
Vp9Encoder::~Vp9Encoder() = default;

Result<Vp9Encoder> Vp9Encoder::make(int width, int height, const VideoFormat& format, Take take) {
  auto state = std::make_unique<State>(width, height, std::move(take));
  vpx_codec_enc_cfg_t settings;
  vpx_codec_iface_t* vp9 = vpx_codec_vp9_cx();
  const std::string error = "The video encoder refuses frames of " + std::to_string(width) + " x " +
                            std::to_string(height) + " pixels. Use another size.";
  if (vpx_codec_enc_config_default(vp9, &settings, 0) != VPX_CODEC_OK) return fail(error);
  settings.g_w = static_cast<unsigned>(width), settings.g_h = static_cast<unsigned>(height);
  settings.g_timebase = {1, 1000};
  // One thread, since with more of them files differ between computers.
  settings.g_threads = 1;
  settings.rc_end_usage = VPX_Q;
  settings.kf_mode = VPX_KF_AUTO;
  settings.kf_max_dist = static_cast<unsigned>(format.framesPerSecond * kMaxBetweenKeyFrames_s);
  if (vpx_codec_enc_init(&state->codec, vp9, &settings, 0) != VPX_CODEC_OK) return fail(error);
  state->isReady = true;
  vpx_codec_control(&state->codec, VP8E_SET_CPUUSED, kSpeed);
  vpx_codec_control(&state->codec, VP8E_SET_CQ_LEVEL, static_cast<unsigned>(format.quality));
  vpx_codec_control(&state->codec, VP9E_SET_COLOR_SPACE, VPX_CS_BT_709);
  vpx_codec_control(&state->codec, VP9E_SET_COLOR_RANGE, VPX_CR_STUDIO_RANGE);
  return Vp9Encoder(std::move(state));
}

Result<void> Vp9Encoder::add(const VideoFrame& frame, std::int64_t time_ms, std::int64_t duration_ms) {
  convert(frame, *state_->image);
  const auto encoded = state_->encode(state_->image, time_ms, duration_ms);
  return encoded ? Result<void>{} : tl::unexpected(encoded.error());
}

Result<void> Vp9Encoder::finish() {
  for (;;) {
    const auto encoded = state_->encode(nullptr, -1, 1);
    if (!encoded) return tl::unexpected(encoded.error());
    if (!*encoded) return {};
  }
}

}  // namespace insonate::video
