// The other program of a connection, built only on the library of OpenIGTLink. It prints one line for each message.
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlMessageHeader.h>
#include <igtlPositionMessage.h>
#include <igtlQuaternionTrackingDataMessage.h>
#include <igtlServerSocket.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <thread>

namespace {

double now_s() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void print(const igtl::Matrix4x4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) std::printf(" %.6f", static_cast<double>(matrix[row][column]));
}

template <class Message>
typename Message::Pointer bodyOf(igtl::ClientSocket& socket, igtl::MessageHeader::Pointer header) {
  auto message = Message::New();
  message->SetMessageHeader(header);
  message->AllocatePack();
  socket.Receive(message->GetPackBodyPointer(), static_cast<int>(message->GetPackBodySize()));
  if ((message->Unpack(1) & igtl::MessageHeader::UNPACK_BODY) == 0) {
    std::printf("CRC\n");
    std::exit(1);
  }
  return message;
}

void printImage(igtl::ClientSocket& socket, const igtl::MessageHeader::Pointer& header) {
  const auto image = bodyOf<igtl::ImageMessage>(socket, header);
  int size[3];
  float spacing[3];
  image->GetDimensions(size);
  image->GetSpacing(spacing);
  igtl::Matrix4x4 matrix;
  image->GetMatrix(matrix);
  const auto* gray = static_cast<const unsigned char*>(image->GetScalarPointer());
  std::printf("IMAGE %s %d %d %d %d %d %f %f %f", header->GetDeviceName(), size[0], size[1], size[2],
              image->GetScalarType(), image->GetCoordinateSystem(), static_cast<double>(spacing[0]),
              static_cast<double>(spacing[1]), static_cast<double>(spacing[2]));
  print(matrix);
  std::printf(" %d %d\n", gray[0], gray[size[0] * size[1] - 1]);
}

/// Connects to a server, sends a command, and prints messages until `count` images have come.
int receive(int port, int count) {
  const auto socket = igtl::ClientSocket::New();
  if (socket->ConnectToServer("127.0.0.1", port) != 0) return 2;
  const auto command = igtl::StringMessage::New();
  command->SetDeviceName("CMD_42");
  command->SetString("<Command Name=\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"50\"/></Command>");
  command->Pack();
  socket->Send(command->GetPackPointer(), static_cast<int>(command->GetPackSize()));
  const double begin_s = now_s();
  for (int images = 0; images < count;) {
    const auto header = igtl::MessageHeader::New();
    header->InitPack();
    const auto size = static_cast<int>(header->GetPackSize());
    if (socket->Receive(header->GetPackPointer(), size) != size) return 3;
    header->Unpack();
    const std::string type = header->GetDeviceType();
    if (type == "IMAGE") {
      printImage(*socket, header);
      ++images;
    } else if (type == "TRANSFORM") {
      igtl::Matrix4x4 matrix;
      bodyOf<igtl::TransformMessage>(*socket, header)->GetMatrix(matrix);
      std::printf("TRANSFORM %s", header->GetDeviceName());
      print(matrix);
      std::printf("\n");
    } else if (type == "STRING") {
      const auto text = bodyOf<igtl::StringMessage>(*socket, header);
      std::printf("STRING %s %s\n", header->GetDeviceName(), text->GetString());
    } else {
      std::printf("OTHER %s\n", type.c_str());
      socket->Skip(static_cast<int>(header->GetBodySizeToRead()), 0);
    }
  }
  std::printf("RATE %.2f\n", count / (now_s() - begin_s));
  socket->CloseSocket();
  return 0;
}

template <class Message>
bool send(igtl::ClientSocket& socket, Message& message) {
  message.Pack();
  return socket.Send(message.GetPackPointer(), static_cast<int>(message.GetPackSize())) != 0;
}

/// Sends each kind of pose once; x counts the rounds.
bool sendPoses(igtl::ClientSocket& socket, int round) {
  igtl::Matrix4x4 matrix;
  igtl::IdentityMatrix(matrix);
  matrix[0][3] = static_cast<float>(round), matrix[1][3] = 2, matrix[2][3] = 3;
  const auto transform = igtl::TransformMessage::New();
  transform->SetDeviceName("ProbeToTracker");
  transform->SetMatrix(matrix);
  const auto tracking = igtl::TrackingDataMessage::New();
  tracking->SetDeviceName("Tracker");
  auto element = igtl::TrackingDataElement::New();
  element->SetName("Needle");
  element->SetType(igtl::TrackingDataElement::TYPE_6D);
  element->SetMatrix(matrix);
  tracking->AddTrackingDataElement(element);
  const auto quaternions = igtl::QuaternionTrackingDataMessage::New();
  quaternions->SetDeviceName("Tracker");
  auto turned = igtl::QuaternionTrackingDataElement::New();
  turned->SetName("Stylus");
  turned->SetType(igtl::QuaternionTrackingDataElement::TYPE_6D);
  turned->SetPosition(static_cast<float>(round), 2, 3);
  turned->SetQuaternion(0, 0.70710678F, 0, 0.70710678F);
  quaternions->AddQuaternionTrackingDataElement(turned);
  const auto position = igtl::PositionMessage::New();
  position->SetDeviceName("Tip");
  position->SetPosition(static_cast<float>(round), 2, 3);
  position->SetQuaternion(0, 0.70710678F, 0, 0.70710678F);
  return send(socket, *transform) && send(socket, *tracking) && send(socket, *quaternions) && send(socket, *position);
}

/// Serves one connection: sends poses `rate` times a second, `count` times.
int serve(int count, int rate) {
  const auto server = igtl::ServerSocket::New();
  if (server->CreateServer(0) != 0) return 2;
  std::printf("PORT %d\n", server->GetServerPort());
  std::fflush(stdout);
  const auto socket = server->WaitForConnection(20'000);
  if (socket.IsNull()) return 3;
  for (int round = 1; round <= count; ++round) {
    if (!sendPoses(*socket, round)) return 4;
    std::this_thread::sleep_for(std::chrono::microseconds(1'000'000 / rate));
  }
  socket->CloseSocket();
  server->CloseSocket();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc == 4 && std::strcmp(argv[1], "receive") == 0) return receive(std::atoi(argv[2]), std::atoi(argv[3]));
  if (argc == 4 && std::strcmp(argv[1], "serve") == 0) return serve(std::atoi(argv[2]), std::atoi(argv[3]));
  std::fprintf(stderr, "usage: igtlink_library_peer receive PORT IMAGES | serve ROUNDS RATE\n");
  return 1;
}
