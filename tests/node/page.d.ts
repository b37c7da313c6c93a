// What tsc is told of the page: some elements have these, and which one stands at a place only the page knows.

interface EventTarget {
  checked: any;
  closest: any;
  disabled: any;
  files: any;
  hidden: any;
  matches: any;
  max: any;
  name: any;
  selectedIndex: any;
  selectionEnd: any;
  selectionStart: any;
  setRangeText: any;
  setSelectionRange: any;
  type: any;
  value: any;
}

interface Element extends HTMLOrSVGElement {}

/** start.js */
declare const pack: any;

interface String {
  encode: any;
}

interface Window {
  curve: any;
  workbench: any;
}
