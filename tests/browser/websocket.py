"""A client for WebSocket (RFC 6455) as far as a driver on the same computer needs it: whole text messages."""
import base64
import itertools
import os
import socket
import struct

TEXT, CLOSE, PING, PONG = 1, 8, 9, 10


class WebSocketError(Exception):
    pass


class WebSocket:
    def __init__(self, host, port, path, timeout):
        self.socket = socket.create_connection((host, port), timeout)
        self.stream = self.socket.makefile("rb")
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET {path} HTTP/1.1\r\nHost: {host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n").encode())
        status = self.stream.readline()
        while self.stream.readline().strip():
            pass
        if b" 101 " not in status:
            raise WebSocketError(f"no WebSocket: {status.decode(errors='replace').strip()}")

    def send_frame(self, kind, data):
        """One frame. A client must mask what it sends (5.3)."""
        count = len(data)
        length = struct.pack(">B", 0x80 | count) if count < 126 else \
            struct.pack(">BH", 0x80 | 126, count) if count < 1 << 16 else struct.pack(">BQ", 0x80 | 127, count)
        mask = os.urandom(4)
        masked = bytes(a ^ b for a, b in zip(data, itertools.cycle(mask)))
        self.socket.sendall(struct.pack(">B", 0x80 | kind) + length + mask + masked)

    def send(self, text):
        self.send_frame(TEXT, text.encode())

    def read(self, count):
        data = self.stream.read(count)
        if len(data) < count:
            raise WebSocketError("the connection has ended")
        return data

    def receive(self):
        """The next message, assembled from its frames."""
        message = b""
        while True:
            first, count = self.read(2)
            if count == 126:
                count, = struct.unpack(">H", self.read(2))
            elif count == 127:
                count, = struct.unpack(">Q", self.read(8))
            data, kind = self.read(count), first & 15
            if kind == CLOSE:
                raise WebSocketError("the connection was closed")
            if kind == PING:
                self.send_frame(PONG, data)
            if kind >= CLOSE:
                continue
            message += data
            if first & 0x80:
                return message.decode()

    def close(self):
        self.stream.close()
        self.socket.close()
