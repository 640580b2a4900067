// SPDX-License-Identifier: BSD-3-Clause
import {EditorView, ViewPlugin} from '@codemirror/view';

/// Keeps the caret in view where one types when the editor becomes lower: messages open above it.
export const caretInView = ViewPlugin.fromClass(class {
  private height: number;
  private readonly watcher: ResizeObserver;

  constructor(private readonly view: EditorView) {
    this.height = view.scrollDOM.clientHeight;
    this.watcher = new ResizeObserver(() => this.resized());
    this.watcher.observe(view.scrollDOM);
  }
  destroy() { this.watcher.disconnect(); }

  private resized() {
    const {view, height} = this, {head} = view.state.selection.main, box = view.scrollDOM.getBoundingClientRect(), caret = view.coordsAtPos(head);
    this.height = box.height;
    const wasSeen = caret !== null && caret.bottom > box.top && caret.top - box.top < height;
    if (view.hasFocus && wasSeen && caret.bottom > box.bottom) view.dispatch({effects: EditorView.scrollIntoView(head, {yMargin: 2 * view.defaultLineHeight})});
  }
});
