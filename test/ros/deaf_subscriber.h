#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <netdb.h>
#include <sys/socket.h>
#include <unistd.h>

#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <xmlrpcpp/XmlRpcClient.h>

namespace ratchet_sieve
{

/// Subscribes to a topic of a node and then reads nothing: like a program that hangs. roscpp's own subscriber
/// cannot do that, because its thread reads all messages.
class DeafSubscriber
{
public:
  /// @param md5 of the message @throws std::runtime_error if the node rejects the connection
  DeafSubscriber(const std::string& node, const std::string& topic, const std::string& md5)
  {
    socket_ = socket(AF_INET, SOCK_STREAM, 0);
    const int little = 4096;
    setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &little, sizeof(little));
    connectTo(node, topic);
    send({"callerid=/deaf", "topic=" + topic, "md5sum=" + md5, "type=*"});
    // The length of the node's answer, which comes if it accepts.
    std::uint32_t length = 0;
    if (recv(socket_, &length, sizeof(length), MSG_WAITALL) != sizeof(length))
      throw std::runtime_error(node + " does not let a subscriber in");
  }
  ~DeafSubscriber() { close(socket_); }
  DeafSubscriber(const DeafSubscriber&) = delete;
  DeafSubscriber& operator=(const DeafSubscriber&) = delete;

private:
  /// Asks the master for the node, and the node for its topic port.
  void connectTo(const std::string& node, const std::string& topic)
  {
    XmlRpc::XmlRpcValue request, response, payload;
    request[0] = ros::this_node::getName();
    request[1] = node;
    std::string host;
    std::uint32_t port = 0;
    if (!ros::master::execute("lookupNode", request, response, payload, false) ||
        !ros::network::splitURI(static_cast<std::string&>(payload), host, port))
      throw std::runtime_error(node + " is not known");
    XmlRpc::XmlRpcClient slave(host.c_str(), static_cast<int>(port));
    request[1] = topic;
    request[2][0][0] = "TCPROS";
    if (!slave.execute("requestTopic", request, response) || response.size() < 3 || response[2].size() < 3)
      throw std::runtime_error(topic + " is not offered");
    addrinfo* address = nullptr;
    const std::string service = std::to_string(static_cast<int&>(response[2][2]));
    addrinfo hints{};
    hints.ai_family = AF_INET;
    if (getaddrinfo(host.c_str(), service.c_str(), &hints, &address) != 0 ||
        connect(socket_, address->ai_addr, address->ai_addrlen) != 0)
      throw std::runtime_error(topic + " cannot be connected to");
    freeaddrinfo(address);
  }

  void send(const std::vector<std::string>& fields)
  {
    const auto number = [](std::size_t size)
    {
      const auto length = static_cast<std::uint32_t>(size);
      return std::string(reinterpret_cast<const char*>(&length), sizeof(length));
    };
    std::string header;
    for (const std::string& field : fields)
      header += number(field.size()) + field;
    header = number(header.size()) + header;
    if (::send(socket_, header.data(), header.size(), 0) != static_cast<ssize_t>(header.size()))
      throw std::runtime_error("the header cannot be sent");
  }

  int socket_ = -1;
};

}  // namespace ratchet_sieve
