#pragma once

#include <gtest/gtest.h>
#include <vpx/vp8dx.h>
#include <vpx/vpx_decoder.h>
#include <webm/callback.h>
#include <webm/file_reader.h>
#include <webm/webm_parser.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace insonate::test {

/// A WebM file as libwebm's parser reads it, decoded by libvpx: neither shares code with the writer.
class WebmReader : public webm::Callback {
 public:
  struct Frame {
    std::int64_t time_ms = 0;
    bool isKey = false;
    std::vector<std::uint8_t> luma;  ///< full range, 0 to 255
  };

  explicit WebmReader(const std::filesystem::path& file) {
    std::FILE* in = std::fopen(file.c_str(), "rb");
    EXPECT_NE(in, nullptr) << file;
    if (!in) return;
    EXPECT_EQ(vpx_codec_dec_init(&codec_, vpx_codec_vp9_dx(), nullptr, 0), VPX_CODEC_OK);
    webm::FileReader reader(in);
    webm::WebmParser parser;
    EXPECT_TRUE(parser.Feed(this, &reader).completed_ok());
    vpx_codec_destroy(&codec_);
  }

  double duration_ms = 0;
  int width = 0, height = 0;
  std::string docType, codec;
  std::vector<Frame> frames;
  std::map<std::int64_t, std::uint64_t> cues;      ///< position in the segment by time in ms
  std::map<std::uint64_t, std::int64_t> clusters;  ///< time in ms by position in the segment
  std::map<std::uint64_t, std::uint64_t> seeks;    ///< position in the segment by the id of what is there
  std::uint64_t cuesAt = 0;

  webm::Status OnEbml(const webm::ElementMetadata&, const webm::Ebml& ebml) override {
    docType = ebml.doc_type.value();
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnSegmentBegin(const webm::ElementMetadata& metadata, webm::Action* action) override {
    segment_ = metadata.position + metadata.header_size;
    *action = webm::Action::kRead;
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnSeek(const webm::ElementMetadata&, const webm::Seek& seek) override {
    seeks[static_cast<std::uint64_t>(seek.id.value())] = seek.position.value();
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnInfo(const webm::ElementMetadata& metadata, const webm::Info& info) override {
    EXPECT_EQ(metadata.position - segment_, seeks[static_cast<std::uint64_t>(webm::Id::kInfo)]);
    EXPECT_EQ(info.timecode_scale.value(), 1'000'000U);
    duration_ms = info.duration.value();
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnTrackEntry(const webm::ElementMetadata&, const webm::TrackEntry& track) override {
    codec = track.codec_id.value();
    width = int(track.video.value().pixel_width.value()), height = int(track.video.value().pixel_height.value());
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnClusterBegin(const webm::ElementMetadata& metadata, const webm::Cluster& cluster,
                              webm::Action* action) override {
    cluster_ms_ = std::int64_t(cluster.timecode.value());
    clusters[metadata.position - segment_] = cluster_ms_;
    *action = webm::Action::kRead;
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnSimpleBlockBegin(const webm::ElementMetadata&, const webm::SimpleBlock& block,
                                  webm::Action* action) override {
    frames.push_back({cluster_ms_ + block.timecode, block.is_key_frame, {}});
    *action = webm::Action::kRead;
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnFrame(const webm::FrameMetadata&, webm::Reader* reader, std::uint64_t* left) override {
    std::vector<std::uint8_t> packet(*left);
    while (*left > 0) {
      std::uint64_t read = 0;
      const auto status = reader->Read(*left, packet.data() + packet.size() - *left, &read);
      *left -= read;
      if (!status.completed_ok() && *left > 0) return status;
    }
    EXPECT_EQ(vpx_codec_decode(&codec_, packet.data(), unsigned(packet.size()), nullptr, 0), VPX_CODEC_OK);
    vpx_codec_iter_t place = nullptr;
    while (const vpx_image_t* image = vpx_codec_get_frame(&codec_, &place)) keep(*image);
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnElementBegin(const webm::ElementMetadata& metadata, webm::Action* action) override {
    if (metadata.id == webm::Id::kCues) cuesAt = metadata.position - segment_;
    *action = webm::Action::kRead;
    return webm::Status(webm::Status::kOkCompleted);
  }
  webm::Status OnCuePoint(const webm::ElementMetadata&, const webm::CuePoint& cue) override {
    cues[std::int64_t(cue.time.value())] = cue.cue_track_positions.at(0).value().cluster_position.value();
    return webm::Status(webm::Status::kOkCompleted);
  }

 private:
  void keep(const vpx_image_t& image) {
    EXPECT_EQ(int(image.d_w), width);
    EXPECT_EQ(int(image.d_h), height);
    EXPECT_EQ(image.cs, VPX_CS_BT_709);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double luma = (image.planes[0][std::ptrdiff_t(y) * image.stride[0] + x] - 16) * 255.0 / 219;
        frames.back().luma.push_back(std::uint8_t(std::min(255.0, std::max(0.0, luma + 0.5))));
      }
  }

  vpx_codec_ctx_t codec_{};
  std::uint64_t segment_ = 0;
  std::int64_t cluster_ms_ = 0;
};

}  // namespace insonate::test
