"use strict";
// Pointer and wheel: turn, shift, zoom, touch; clicks are told from drags.

class Controls {
  // handlers: {click(x, y), hover(x, y), leave(), doubleClick(x, y)}
  constructor(view, handlers) {
    this.view = view;
    this.handlers = handlers;
    this.pointers = new Map();
    const canvas = view.canvas;
    canvas.addEventListener("pointerdown", event => this.down(event));
    canvas.addEventListener("pointermove", event => this.move(event));
    canvas.addEventListener("pointerup", event => this.up(event));
    canvas.addEventListener("pointercancel", event => this.pointers.delete(event.pointerId));
    canvas.addEventListener("pointerleave", () => handlers.leave());
    canvas.addEventListener("contextmenu", event => event.preventDefault());
    canvas.addEventListener("dblclick", event => handlers.doubleClick(event.offsetX, event.offsetY));
    canvas.addEventListener("wheel", event => {
      event.preventDefault();
      const lines = event.deltaMode === 1 ? 16 : 1;
      view.zoom(Math.exp(0.0012 * lines * event.deltaY), event.offsetX, event.offsetY);
    }, {passive: false});
  }

  down(event) {
    this.view.canvas.setPointerCapture(event.pointerId);
    this.view.canvas.focus({preventScroll: true});
    this.pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
    this.start = {x: event.offsetX, y: event.offsetY};
    this.isDrag = false;
    this.handlers.leave();
  }

  move(event) {
    const last = this.pointers.get(event.pointerId), x = event.offsetX, y = event.offsetY;
    if (!last) {
      this.handlers.hover(x, y);
      return;
    }
    this.isDrag = this.isDrag || Math.hypot(x - this.start.x, y - this.start.y) > 4;
    if (!this.isDrag) {
      return;
    }
    const dx = x - last.x, dy = y - last.y;
    if (this.pointers.size === 2) {
      const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
      const before = Math.hypot(last.x - other.x, last.y - other.y), now = Math.hypot(x - other.x, y - other.y);
      this.view.zoom(before / Math.max(1, now), (x + other.x) / 2, (y + other.y) / 2);
      this.view.shift(dx / 2, dy / 2);
    } else if (event.buttons === 1 && !event.shiftKey && !event.ctrlKey) {
      this.view.turn(dx, dy);
    } else {
      this.view.shift(dx, dy);
    }
    this.pointers.set(event.pointerId, {x, y});
  }

  up(event) {
    this.pointers.delete(event.pointerId);
    if (!this.isDrag && event.button === 0) {
      this.handlers.click(event.offsetX, event.offsetY);
    }
  }
}
