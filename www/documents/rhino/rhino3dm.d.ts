// The smaller build of the package, which declares the types of the other one.
declare module 'rhino3dm/rhino3dm.module.min.js' {
  export { default } from 'rhino3dm';
}
