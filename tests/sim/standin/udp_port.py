"""A UDP port on the host's sockets."""

import json
import socket


class UdpPort:
    """A UDP port as the firmware has it; where it sends to stands in wifi.json."""

    def __init__(self, name, host, port, local_port, credentials, retry_ms, log):
        self.name = name
        self.dropped = self.sent = self.received = 0
        self.is_up = True
        with open(credentials) as file:
            settings = json.load(file)
        self.home = socket.getaddrinfo(settings["host"], settings["port"])[0][-1]
        self.ends = [self.home, None]
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(socket.getaddrinfo("0.0.0.0", settings["local_port"])[0][-1])
        self._socket.setblocking(False)

    def read(self):
        try:
            data, self.ends[0] = self._socket.recvfrom(1472)
        except OSError:
            return None
        self.received += len(data)
        return data

    def write(self, frame):
        try:
            self._socket.sendto(bytes(frame), self.ends[0])
        except OSError:
            self.dropped += 1
            return 0
        self.sent += len(frame)
        return len(frame)

    def poll(self, now_ms):
        pass
