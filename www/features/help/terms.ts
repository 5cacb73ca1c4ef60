/** The words with a meaning of their own, as the documentation of the crate (`src/lib.rs`) has them. */

export const TERMS: [string, string][] = [
  ['panel', 'a face of the mesh, as a part that is built'],
  ['original', 'the mesh as opened, to which closeness and smoothness refer'],
  ['handle', 'vertices that are pulled to targets'],
  ['fixed', 'of handles that stay at their targets exactly'],
  ['tolerance', 'the distance up to which a panel, or another element, is as it shall be'],
  [
    'relaxed tolerance',
    'a larger tolerance for some panels, where no shape within the required one can be built',
  ],
  ['satisfied', 'within the length that is required'],
  ['estimate', 'said before a press: how far it will move the mesh'],
  ['suggestion', 'an edit that helps, tried before it is offered'],
  ['front', 'the side of a face that its normal points to; the back is bluish in the view'],
];
