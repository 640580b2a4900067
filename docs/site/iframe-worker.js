// SPDX-License-Identifier: BSD-3-Clause
// Pages that are opened as files cannot start a worker. The search then runs in a hidden frame instead. (The name keeps
// the plugin of offline pages from loading such a script from the network.)
if (location.protocol === "file:") {
  window.Worker = class extends EventTarget {
    constructor(script) {
      super();
      this.waiting = [];
      this.frame = document.createElement("iframe");
      this.frame.hidden = true;
      document.body.append(this.frame);
      const inside = this.frame.contentWindow;
      inside.postMessage = (data) => this.dispatchEvent(new MessageEvent("message", { data }));
      const element = inside.document.createElement("script");
      element.src = new URL(script, location);
      element.onload = () => {
        this.loaded = true;
        for (const data of this.waiting) this.postMessage(data);
      };
      inside.document.body.append(element);
    }
    postMessage(data) {
      if (!this.loaded) this.waiting.push(data);
      else this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data }));
    }
    terminate() {
      this.frame.remove();
    }
  };
}
