/**
 * What the studies' engine takes and gives, as `src/web/studies.rs` has it.
 *
 * @typedef {'glance' | 'class' | 'paper'} Size
 *
 * @typedef {object} Fault why a text is no study
 * @property {string} path of the field; empty where the text is no JSON
 * @property {string} message what was found and what is allowed
 *
 * @typedef {object} SizeOutline
 * @property {Size} size
 * @property {number} runs
 * @property {number} seeds
 * @property {number} robot_steps robots times steps over all runs, if none ends early
 * @property {string} hash by which results are kept
 *
 * @typedef {object} Outline what a valid study says
 * @property {string} name
 * @property {string} title
 * @property {string} about
 * @property {string} world that all cells are of
 * @property {string[]} cells
 * @property {string[]} factors what the cells differ in
 * @property {SizeOutline[]} sizes those that the study has
 *
 * @typedef {object} Plan what there is to do; run `i` is of cell `i` modulo the cells
 * @property {string} world
 * @property {string[]} cells
 * @property {number} runs
 * @property {number} seeds
 * @property {number[]} robot_steps of one run of each cell
 * @property {string} hash
 * @property {string} version
 * @property {string} header of the results file
 *
 * @typedef {object} Section one table of a report
 * @property {string} name of the metric, or `tests`, or `paper`
 * @property {string} title
 * @property {string} note
 * @property {string[]} columns
 * @property {string[][]} rows
 *
 * @typedef {object} Report
 * @property {string} title
 * @property {string} about
 * @property {string} extent such as `7 of 10 seeds from 1 in each cell, not complete`
 * @property {string} run
 * @property {[reason: string, count: number][]} failures
 * @property {Section[]} sections
 *
 * @typedef {object} Reported
 * @property {string} results the results file, rows in order
 * @property {number[]} missing
 * @property {string} markdown
 * @property {Report} report
 * @property {string | null} figure as SVG
 *
 * @typedef {object} MetricWords
 * @property {string} name
 * @property {string} world that it measures
 * @property {string} label
 * @property {string} help
 */

export const SIZES = /** @type {const} */ (['glance', 'class', 'paper']);
