// A rosbridge server without ROS: what one client publishes goes to all who subscribed. As the real one it knows
// topics by their types, and says in a status message what it cannot do.

export class Relay {
  twists = []; // published on cmd_vel: {at: ms, x: m/s}
  statuses = [];
  #server;
  #clients = new Map(); // socket -> {hears, tells}: names of topics
  #types = new Map();

  constructor(WebSocketServer, port) {
    this.#server = new WebSocketServer({ port, host: "127.0.0.1" });
    this.ready = new Promise((resolve) => this.#server.on("listening", resolve));
    this.#server.on("connection", (socket) => {
      this.#clients.set(socket, { hears: new Set(), tells: new Set() });
      socket.on("message", (data, binary) => this.#take(socket, data, binary));
      socket.on("close", () => this.#clients.delete(socket));
      socket.on("error", () => {});
    });
  }
  get port() {
    return this.#server.address().port;
  }
  get url() {
    return `ws://127.0.0.1:${this.port}`;
  }
  // As a power cut: nobody hears a word.
  async kill() {
    for (const socket of this.#clients.keys()) socket.terminate();
    await new Promise((resolve) => this.#server.close(resolve));
  }
  #refuse(socket, { id }, msg) {
    this.statuses.push(msg);
    socket.send(JSON.stringify({ op: "status", level: "error", msg, id }));
  }
  // ROS 2's servers take "nav_msgs/Odometry" for "nav_msgs/msg/Odometry", as ROS 1's clients write it.
  #knows(socket, operation) {
    const type = operation.type?.replace("/msg/", "/");
    const known = this.#types.get(operation.topic) ?? type;
    if (type && type !== known) {
      this.#refuse(socket, operation, `${operation.topic} is of type ${known}, not ${type}`);
      return false;
    }
    if (known) this.#types.set(operation.topic, known);
    return true;
  }
  #take(socket, data, binary) {
    const operation = binary ? {} : JSON.parse(data.toString());
    const { op, topic } = operation;
    const { hears, tells } = this.#clients.get(socket);
    if (op === "subscribe") {
      if (this.#knows(socket, operation)) hears.add(topic);
    } else if (op === "unsubscribe") {
      hears.delete(topic);
    } else if (op === "advertise") {
      if (this.#knows(socket, operation)) tells.add(topic);
    } else if (op === "unadvertise") {
      tells.delete(topic);
    } else if (op === "publish") {
      if (!tells.has(topic)) return this.#refuse(socket, operation, `${topic} was not advertised`);
      if (topic === "/cmd_vel") {
        const twist = operation.msg.twist ?? operation.msg;
        this.twists.push({ at: performance.now(), x: twist.linear.x });
      }
      const text = JSON.stringify({ op: "publish", topic, msg: operation.msg });
      for (const [other, { hears: wanted }] of this.#clients) if (wanted.has(topic)) other.send(text);
    } else {
      this.#refuse(socket, operation, `unknown operation: ${op}`);
    }
  }
}
