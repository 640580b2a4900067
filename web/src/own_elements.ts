// SPDX-License-Identifier: BSD-3-Clause
// Every widget of a notebook loads the module again, but a document defines an element once: the first module's elements
// serve all. The build puts this in the place of the browser's registry.
export const customElements = {
  define(name: string, element: CustomElementConstructor) {
    if (!globalThis.customElements.get(name)) globalThis.customElements.define(name, element);
  },
};
