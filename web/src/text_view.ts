// SPDX-License-Identifier: BSD-3-Clause
import {autocompletion, completionKeymap, type CompletionContext, type CompletionResult} from '@codemirror/autocomplete';
import {defaultKeymap, history, historyKeymap} from '@codemirror/commands';
import {HighlightStyle, StreamLanguage, syntaxHighlighting} from '@codemirror/language';
import {toml} from '@codemirror/legacy-modes/mode/toml';
import {lintGutter, setDiagnostics, type Diagnostic} from '@codemirror/lint';
import {Annotation, Compartment, EditorState} from '@codemirror/state';
import {EditorView, keymap, lineNumbers} from '@codemirror/view';
import {tags} from '@lezer/highlight';
import {caretInView} from './caret_in_view.ts';
import {completionsAt} from './completions.ts';
import {EngineError} from './engine.ts';
import {edited, withPlainEnds, type Edit} from './line_ends.ts';
import {Part} from './part.ts';
import type {Problem} from './results.ts';
import type {Design} from './state.ts';

const OF_THE_PAGE = Annotation.define<boolean>();  // a change that no hand made in the editor
const PAUSE = 300;  // ms after a key, before the text is checked

/// The project file as text, with the program's messages at their lines and completion from the schema.
export class TextView extends Part {
  private editor: EditorView | null = null;
  private readonly look = new Compartment();
  private theme = '';
  private shown: Problem[] = [];
  private file = '';  // the text in the editor with the line ends of the file
  private timer = 0;
  private refused: Design | null = null;  // its settings cannot be written into the text
  private wasAway = false;  // the program that writes them

  /// A shadow root of its own: the editor puts its styles there as a constructed sheet, which the page's policy allows.
  override createRenderRoot(): ShadowRoot { return this.attachShadow({mode: 'open'}); }
  override render() { return undefined; }
  override firstUpdated() {
    const {state} = this.app;
    this.file = state.design.text;
    this.editor = new EditorView({root: this.shadowRoot!, parent: this.shadowRoot!, state: EditorState.create({doc: state.design.text, extensions: [
      lineNumbers(), history(), lintGutter(), caretInView, StreamLanguage.define(toml), this.look.of([]),
      autocompletion({override: [context => this.complete(context)]}),
      keymap.of([...defaultKeymap, ...historyKeymap, ...completionKeymap]),
      EditorView.contentAttributes.of({'aria-label': 'Project file'}),
      EditorView.updateListener.of(update => {
        if (!update.docChanged || update.transactions.some(t => t.annotation(OF_THE_PAGE))) return;
        const edits: Edit[] = [];
        update.changes.iterChanges((from, to, _, __, insert) => edits.push({from, to, insert: insert.toString()}));
        this.file = edited(this.file, edits);
        clearTimeout(this.timer);
        this.timer = window.setTimeout(() => state.edit(this.file), PAUSE);
      })]})});
    this.editor.scrollDOM.tabIndex = 0;  // long lines are scrolled by keys, too
    void this.fold();
    this.updated();
  }
  override updated() {
    const {editor} = this, {state, asker, display, file} = this.app, isAway = file?.trouble?.kind === 'away';
    if (!editor) return;
    if (this.wasAway && !isAway) this.refused = null;
    this.wasAway = isAway;
    const isEdited = this.timer !== 0 && editor.hasFocus, {text} = state.design;
    if (this.file !== text && !isEdited) {
      if (withPlainEnds(this.file) !== withPlainEnds(text))
        editor.dispatch({changes: {from: 0, to: editor.state.doc.length, insert: text}, annotations: OF_THE_PAGE.of(true)});
      this.file = text;
      this.shown = [];
    }
    if (this.file === text) this.timer = 0;
    if (this.theme !== display.theme) editor.dispatch({effects: this.look.reconfigure(appearance(display.theme === 'dark'))});
    this.theme = display.theme;
    if (this.shown !== asker.problems) editor.dispatch(setDiagnostics(editor.state, asker.problems.flatMap(p => this.diagnostic(p))));
    this.shown = asker.problems;
    void this.fold();
  }
  override disconnectedCallback() {
    super.disconnectedCallback();
    this.editor?.destroy();
    this.editor = null;
  }
  show(line: number) {
    const {editor} = this;
    if (!editor || line < 1 || line > editor.state.doc.lines) return;
    const {from} = editor.state.doc.line(line);
    editor.dispatch({selection: {anchor: from}, effects: EditorView.scrollIntoView(from, {y: 'center'})});
    editor.focus();
  }

  /// The text shows what sliders changed, too: the program writes it.
  private async fold() {
    const {state, engine} = this.app, {design} = state;
    if (!design.settings.size) return;
    if (this.refused === design) return;
    try {
      const text = await engine.text(state.change);
      if (state.design === design) state.folded(text);
    } catch (error) {
      this.refused = design;
      const notice = `The text does not show the sliders: ${(error as Error).message}.`;
      this.app.display.set({notice, listed: error instanceof EngineError && error.isListed ? notice : ''});
    }
  }
  private diagnostic({line, column, message, severity}: Problem): Diagnostic[] {
    const {doc} = this.editor!.state;
    if (!line || line > doc.lines) return [];
    const {from, to} = doc.line(line), start = Math.min(from + Math.max((column ?? 1) - 1, 0), to);
    return [{from: start, to, severity, message}];
  }
  private complete(context: CompletionContext): CompletionResult | null {
    const {schema} = this.app, found = schema && completionsAt(context.state.doc.toString(), context.pos, schema);
    if (!found || (!context.explicit && found.from === context.pos)) return null;
    return {from: found.from, validFor: /^[\w-]*$/, options: found.options.map(o => ({
      label: o.name, detail: o.description, apply: o.apply, type: o.apply.includes('=') ? 'property' : 'constant'}))};
  }
}

function appearance(dark: boolean) {
  const c = dark ? {text: '#dbe5ec', key: '#7cc7f2', text2: '#a8d8a0', number: '#ffb347', comment: '#93a4af', back: '#14191d', line: '#1d252b'}
                 : {text: '#24323b', key: '#00527f', text2: '#1c6b2f', number: '#9a4a00', comment: '#5d6d77', back: '#ffffff', line: '#eef3f7'};
  return [
    EditorView.theme({
      '&': {height: '100%', fontSize: '12px', color: c.text, backgroundColor: c.back},
      '.cm-scroller': {fontFamily: 'ui-monospace, "DejaVu Sans Mono", monospace'},
      '.cm-gutters': {backgroundColor: c.line, color: c.comment, border: 'none'},
      '.cm-content': {caretColor: c.text},
      '.cm-tooltip': {backgroundColor: c.line, color: c.text, maxWidth: '420px'},
    }, {dark}),
    syntaxHighlighting(HighlightStyle.define([
      {tag: [tags.propertyName, tags.atom], color: c.key}, {tag: tags.string, color: c.text2}, {tag: tags.number, color: c.number},
      {tag: tags.comment, color: c.comment}]))];
}
customElements.define('text-view', TextView);
