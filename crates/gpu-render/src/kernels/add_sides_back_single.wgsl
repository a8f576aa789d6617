// Compiled from boundary_back.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 7745810d8c6fd150
// result: 752de939f90528d4

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

struct s_bwdCallableCtx_sqrt_0
{
     _S1 : f32,
};

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

fn _d_sqrt_0( dpx_0 : ptr<function, DiffPair_float_0>,  dOut_0 : f32)
{
    var _S2 : f32 = 0.5f / sqrt(max(1.00000001168609742e-07f, (*dpx_0).primal_0)) * dOut_0;
    (*dpx_0).primal_0 = (*dpx_0).primal_0;
    (*dpx_0).differential_0 = _S2;
    return;
}

fn s_bwdProp_sqrt_0( ctx_0 : s_bwdCallableCtx_sqrt_0,  d_x_0 : ptr<function, f32>,  d_out_0 : f32)
{
    var _S3 : DiffPair_float_0;
    _S3.primal_0 = ctx_0._S1;
    _d_sqrt_0(&(_S3), d_out_0);
    (*d_x_0) = _S3.differential_0;
    return;
}

struct Tuple_0
{
     value0_0 : f32,
};

fn s_apply_length_0( x_0 : vec3<f32>) -> Tuple_0
{
    var _S4 : Tuple_0 = Tuple_0( length(x_0) );
    return _S4;
}

struct s_bwdCallableCtx_length_0
{
     _S5 : vec3<f32>,
};

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_length_impl_0
{
     value0_1 : vec3<f32>,
};

struct s_bwdCallableCtx_length_impl_0
{
     value0_2 : s_paramCtx_s_bwdCallableCtx_length_impl_0,
};

fn s_bwdProp_length_impl_0( _S6 : s_bwdCallableCtx_length_impl_0,  _S7 : ptr<function, vec3<f32>>,  _S8 : f32)
{
    var _S9 : f32 = _S6.value0_2.value0_1[i32(0)];
    var _S10 : f32 = _S6.value0_2.value0_1[i32(1)];
    var _S11 : f32 = _S6.value0_2.value0_1[i32(2)];
    var _S12 : s_bwdCallableCtx_sqrt_0;
    _S12._S1 = _S9 * _S9 + _S10 * _S10 + _S11 * _S11;
    var _S13 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S12, &(_S13), _S8);
    var _S14 : f32 = _S6.value0_2.value0_1[i32(2)] * _S13;
    var _S15 : f32 = _S14 + _S14;
    var _S16 : f32 = _S6.value0_2.value0_1[i32(1)] * _S13;
    var _S17 : f32 = _S16 + _S16;
    var _S18 : f32 = _S6.value0_2.value0_1[i32(0)] * _S13;
    var _S19 : f32 = _S18 + _S18;
    var _S20 : vec3<f32> = vec3<f32>(0.0f);
    _S20[i32(2)] = _S15;
    _S20[i32(1)] = _S17;
    _S20[i32(0)] = _S19;
    (*_S7) = _S20;
    return;
}

fn _S21( _S22 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S23 : f32)
{
    var _S24 : s_paramCtx_s_bwdCallableCtx_length_impl_0;
    _S24.value0_1 = (*_S22).primal_0;
    var _S25 : s_bwdCallableCtx_length_impl_0 = s_bwdCallableCtx_length_impl_0( _S24 );
    var _S26 : vec3<f32> = (*_S22).differential_0;
    s_bwdProp_length_impl_0(_S25, &(_S26), _S23);
    (*_S22).differential_0 = _S26;
    return;
}

fn s_bwdProp_length_0( ctx_1 : s_bwdCallableCtx_length_0,  d_x_1 : ptr<function, vec3<f32>>,  d_out_1 : f32)
{
    var _S27 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S27.primal_0 = ctx_1._S5;
    _S21(&(_S27), d_out_1);
    (*d_x_1) = _S27.differential_0;
    return;
}

struct s_bwdCallableCtx_cross_0
{
     _S28 : vec3<f32>,
     _S29 : vec3<f32>,
};

fn _d_cross_0( a_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  b_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_1 : vec3<f32>)
{
    var _S30 : f32 = dOut_1.y;
    var _S31 : f32 = dOut_1.z;
    var _S32 : f32 = dOut_1.x;
    var _S33 : f32 = (*a_0).primal_0.z * _S30 + - (*a_0).primal_0.y * _S31;
    var _S34 : f32 = - (*a_0).primal_0.z * _S32 + (*a_0).primal_0.x * _S31;
    var _S35 : f32 = (*a_0).primal_0.y * _S32 + - (*a_0).primal_0.x * _S30;
    var _S36 : vec3<f32> = vec3<f32>(- (*b_0).primal_0.z * _S30 + (*b_0).primal_0.y * _S31, (*b_0).primal_0.z * _S32 + - (*b_0).primal_0.x * _S31, - (*b_0).primal_0.y * _S32 + (*b_0).primal_0.x * _S30);
    (*a_0).primal_0 = (*a_0).primal_0;
    (*a_0).differential_0 = _S36;
    var _S37 : vec3<f32> = vec3<f32>(_S33, _S34, _S35);
    (*b_0).primal_0 = (*b_0).primal_0;
    (*b_0).differential_0 = _S37;
    return;
}

fn s_bwdProp_cross_0( ctx_2 : s_bwdCallableCtx_cross_0,  d_left_0 : ptr<function, vec3<f32>>,  d_right_0 : ptr<function, vec3<f32>>,  d_out_2 : vec3<f32>)
{
    var _S38 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S38.primal_0 = ctx_2._S28;
    var _S39 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S39.primal_0 = ctx_2._S29;
    _d_cross_0(&(_S38), &(_S39), d_out_2);
    (*d_left_0) = _S38.differential_0;
    (*d_right_0) = _S39.differential_0;
    return;
}

struct Tuple_1
{
     value0_3 : vec3<f32>,
};

fn s_apply_normalize_0( x_1 : vec3<f32>) -> Tuple_1
{
    var _S40 : Tuple_1 = Tuple_1( normalize(x_1) );
    return _S40;
}

struct s_bwdCallableCtx_normalize_0
{
     _S41 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_normalize_impl_0
{
     value0_4 : vec3<f32>,
};

struct s_bwdCallableCtx_normalize_impl_0
{
     value0_5 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0,
};

fn s_bwdProp_normalize_impl_0( _S42 : s_bwdCallableCtx_normalize_impl_0,  _S43 : ptr<function, vec3<f32>>,  _S44 : vec3<f32>)
{
    var _S45 : Tuple_0 = s_apply_length_0(_S42.value0_5.value0_4);
    var _S46 : s_bwdCallableCtx_length_0;
    _S46._S5 = _S42.value0_5.value0_4;
    var _S47 : vec3<f32> = _S42.value0_5.value0_4 * _S44;
    var _S48 : vec3<f32> = vec3<f32>((1.0f / _S45.value0_0)) * _S44;
    var _S49 : f32 = - ((_S47[i32(0)] + _S47[i32(1)] + _S47[i32(2)]) / (_S45.value0_0 * _S45.value0_0));
    var _S50 : vec3<f32> = vec3<f32>(0.0f);
    s_bwdProp_length_0(_S46, &(_S50), _S49);
    (*_S43) = _S48 + _S50;
    return;
}

fn _S51( _S52 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S53 : vec3<f32>)
{
    var _S54 : s_paramCtx_s_bwdCallableCtx_normalize_impl_0;
    _S54.value0_4 = (*_S52).primal_0;
    var _S55 : s_bwdCallableCtx_normalize_impl_0 = s_bwdCallableCtx_normalize_impl_0( _S54 );
    var _S56 : vec3<f32> = (*_S52).differential_0;
    s_bwdProp_normalize_impl_0(_S55, &(_S56), _S53);
    (*_S52).differential_0 = _S56;
    return;
}

fn s_bwdProp_normalize_0( ctx_3 : s_bwdCallableCtx_normalize_0,  d_x_2 : ptr<function, vec3<f32>>,  d_out_3 : vec3<f32>)
{
    var _S57 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S57.primal_0 = ctx_3._S41;
    _S51(&(_S57), d_out_3);
    (*d_x_2) = _S57.differential_0;
    return;
}

struct Tuple_2
{
     value0_6 : f32,
};

fn s_apply_dot_0( x_2 : vec3<f32>,  y_0 : vec3<f32>) -> Tuple_2
{
    var _S58 : Tuple_2 = Tuple_2( dot(x_2, y_0) );
    return _S58;
}

struct s_bwdCallableCtx_dot_0
{
     _S59 : vec3<f32>,
     _S60 : vec3<f32>,
};

fn _d_dot_0( dpx_1 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dpy_0 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  dOut_2 : f32)
{
    var x_d_result_0 : vec3<f32>;
    x_d_result_0[i32(0)] = (*dpy_0).primal_0[i32(0)] * dOut_2;
    var y_d_result_0 : vec3<f32>;
    y_d_result_0[i32(0)] = (*dpx_1).primal_0[i32(0)] * dOut_2;
    x_d_result_0[i32(1)] = (*dpy_0).primal_0[i32(1)] * dOut_2;
    y_d_result_0[i32(1)] = (*dpx_1).primal_0[i32(1)] * dOut_2;
    x_d_result_0[i32(2)] = (*dpy_0).primal_0[i32(2)] * dOut_2;
    y_d_result_0[i32(2)] = (*dpx_1).primal_0[i32(2)] * dOut_2;
    (*dpx_1).primal_0 = (*dpx_1).primal_0;
    (*dpx_1).differential_0 = x_d_result_0;
    (*dpy_0).primal_0 = (*dpy_0).primal_0;
    (*dpy_0).differential_0 = y_d_result_0;
    return;
}

fn s_bwdProp_dot_0( ctx_4 : s_bwdCallableCtx_dot_0,  d_x_3 : ptr<function, vec3<f32>>,  d_y_0 : ptr<function, vec3<f32>>,  d_out_4 : f32)
{
    var _S61 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S61.primal_0 = ctx_4._S59;
    var _S62 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    _S62.primal_0 = ctx_4._S60;
    _d_dot_0(&(_S61), &(_S62), d_out_4);
    (*d_x_3) = _S61.differential_0;
    (*d_y_0) = _S62.differential_0;
    return;
}

struct s_bwdCallableCtx_max_0
{
     _S63 : f32,
     _S64 : f32,
};

fn _d_max_0( dpx_2 : ptr<function, DiffPair_float_0>,  dpy_1 : ptr<function, DiffPair_float_0>,  dOut_3 : f32)
{
    var _S65 : DiffPair_float_0 = (*dpx_2);
    var _S66 : f32;
    if(((*dpx_2).primal_0) > ((*dpy_1).primal_0))
    {
        _S66 = dOut_3;
    }
    else
    {
        if(((*dpx_2).primal_0) < ((*dpy_1).primal_0))
        {
            _S66 = 0.0f;
        }
        else
        {
            _S66 = 0.5f * dOut_3;
        }
    }
    (*dpx_2).primal_0 = _S65.primal_0;
    (*dpx_2).differential_0 = _S66;
    var _S67 : DiffPair_float_0 = (*dpy_1);
    if(((*dpy_1).primal_0) > (_S65.primal_0))
    {
        _S66 = dOut_3;
    }
    else
    {
        if(((*dpy_1).primal_0) < ((*dpx_2).primal_0))
        {
            _S66 = 0.0f;
        }
        else
        {
            _S66 = 0.5f * dOut_3;
        }
    }
    (*dpy_1).primal_0 = _S67.primal_0;
    (*dpy_1).differential_0 = _S66;
    return;
}

fn s_bwdProp_max_0( ctx_5 : s_bwdCallableCtx_max_0,  d_x_4 : ptr<function, f32>,  d_y_1 : ptr<function, f32>,  d_out_5 : f32)
{
    var _S68 : DiffPair_float_0;
    _S68.primal_0 = ctx_5._S63;
    var _S69 : DiffPair_float_0;
    _S69.primal_0 = ctx_5._S64;
    _d_max_0(&(_S68), &(_S69), d_out_5);
    (*d_x_4) = _S68.differential_0;
    (*d_y_1) = _S69.differential_0;
    return;
}

struct Tuple_3
{
     value0_7 : f32,
};

fn s_apply_abs_0( x_3 : f32) -> Tuple_3
{
    var _S70 : Tuple_3 = Tuple_3( abs(x_3) );
    return _S70;
}

struct s_bwdCallableCtx_abs_0
{
     _S71 : f32,
};

fn _d_abs_0( dpx_3 : ptr<function, DiffPair_float_0>,  dOut_4 : f32)
{
    var _S72 : f32 = select(select(-1.0f, 0.0f, ((*dpx_3).primal_0) == 0.0f), 1.0f, ((*dpx_3).primal_0) > 0.0f) * dOut_4;
    (*dpx_3).primal_0 = (*dpx_3).primal_0;
    (*dpx_3).differential_0 = _S72;
    return;
}

fn s_bwdProp_abs_0( ctx_6 : s_bwdCallableCtx_abs_0,  d_x_5 : ptr<function, f32>,  d_out_6 : f32)
{
    var _S73 : DiffPair_float_0;
    _S73.primal_0 = ctx_6._S71;
    _d_abs_0(&(_S73), d_out_6);
    (*d_x_5) = _S73.differential_0;
    return;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_0 : vec3<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_axes_around_0
{
     value0_8 : vec3<f32>,
     value1_0 : bool,
};

struct s_bwdCallableCtx_axes_around_0
{
     value0_9 : s_paramCtx_s_bwdCallableCtx_axes_around_0,
};

fn s_bwdProp_axes_around_0( _S74 : s_bwdCallableCtx_axes_around_0,  _S75 : ptr<function, vec3<f32>>,  _S76 : Axes_0)
{
    var _S77 : f32 = _S74.value0_9.value0_8.z;
    var sign_0 : f32;
    if(_S77 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S78 : f32 = sign_0 + _S77;
    var a_1 : f32 = -1.0f / _S78;
    var _S79 : f32 = _S78 * _S78;
    var _S80 : f32 = _S74.value0_9.value0_8.x;
    var _S81 : f32 = _S74.value0_9.value0_8.y;
    var _S82 : f32 = _S80 * _S81;
    var _S83 : f32 = sign_0 * _S80;
    var _S84 : f32 = _S83 * _S80;
    var _S85 : f32 = - sign_0;
    var _S86 : f32 = _S81 * _S81;
    var _S87 : f32 = _S81 * (a_1 * _S76.t_0[i32(1)]);
    var _S88 : f32 = a_1 * _S76.s_0[i32(0)];
    var _S89 : f32 = _S76.t_0[i32(0)] + sign_0 * _S76.s_0[i32(1)];
    var _S90 : f32 = a_1 * _S89;
    var _S91 : vec3<f32> = vec3<f32>(_S85 * _S76.s_0[i32(2)] + _S83 * _S88 + sign_0 * (_S80 * _S88) + _S81 * _S90, - _S76.t_0[i32(2)] + _S87 + _S87 + _S80 * _S90, 0.0f) + vec3<f32>(0.0f, 0.0f, -1.0f * - ((_S86 * _S76.t_0[i32(1)] + _S84 * _S76.s_0[i32(0)] + _S82 * _S89) / _S79));
    var _S92 : vec3<f32>;
    if(_S74.value0_9.value1_0)
    {
        _S92 = _S76.n_0 + _S91;
    }
    else
    {
        _S92 = (vec3<f32>(0) - _S76.n_0) + _S91;
    }
    (*_S75) = _S92;
    return;
}

fn _S93( _S94 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S95 : bool,  _S96 : Axes_0)
{
    var _S97 : s_paramCtx_s_bwdCallableCtx_axes_around_0;
    _S97.value0_8 = (*_S94).primal_0;
    _S97.value1_0 = _S95;
    var _S98 : s_bwdCallableCtx_axes_around_0 = s_bwdCallableCtx_axes_around_0( _S97 );
    var _S99 : vec3<f32> = (*_S94).differential_0;
    s_bwdProp_axes_around_0(_S98, &(_S99), _S96);
    (*_S94).differential_0 = _S99;
    return;
}

struct s_paramCtx_s_bwdCallableCtx_axes_along_0
{
     value0_10 : vec3<f32>,
     value1_1 : vec3<f32>,
     value2_0 : bool,
};

struct s_bwdCallableCtx_axes_along_0
{
     value0_11 : s_paramCtx_s_bwdCallableCtx_axes_along_0,
};

fn s_bwdProp_axes_along_0( _S100 : s_bwdCallableCtx_axes_along_0,  _S101 : ptr<function, vec3<f32>>,  _S102 : ptr<function, vec3<f32>>,  _S103 : Axes_0)
{
    var _S104 : vec3<f32> = vec3<f32>(s_apply_dot_0(_S100.value0_11.value0_10, _S100.value0_11.value1_1).value0_6);
    var _S105 : s_bwdCallableCtx_dot_0;
    _S105._S59 = _S100.value0_11.value0_10;
    _S105._S60 = _S100.value0_11.value1_1;
    var _S106 : vec3<f32> = _S100.value0_11.value1_1 - _S100.value0_11.value0_10 * _S104;
    var _S107 : Tuple_1 = s_apply_normalize_0(_S106);
    var _S108 : s_bwdCallableCtx_normalize_0;
    _S108._S41 = _S106;
    var _S109 : s_bwdCallableCtx_cross_0;
    _S109._S28 = _S100.value0_11.value0_10;
    _S109._S29 = _S107.value0_3;
    var _S110 : vec3<f32> = vec3<f32>(0.0f);
    var _S111 : vec3<f32> = _S110;
    var _S112 : vec3<f32> = _S110;
    s_bwdProp_cross_0(_S109, &(_S111), &(_S112), _S103.t_0);
    var _S113 : vec3<f32> = _S103.s_0 + _S112;
    var _S114 : vec3<f32> = _S110;
    s_bwdProp_normalize_0(_S108, &(_S114), _S113);
    var _S115 : vec3<f32> = (vec3<f32>(0) - _S114);
    var _S116 : vec3<f32> = _S100.value0_11.value0_10 * _S115;
    var _S117 : vec3<f32> = _S104 * _S115;
    var _S118 : f32 = _S116[i32(0)] + _S116[i32(1)] + _S116[i32(2)];
    var _S119 : vec3<f32> = _S110;
    var _S120 : vec3<f32> = _S110;
    s_bwdProp_dot_0(_S105, &(_S119), &(_S120), _S118);
    var _S121 : vec3<f32> = _S111 + _S117 + _S119;
    var _S122 : vec3<f32> = _S114 + _S120;
    var _S123 : vec3<f32>;
    if(_S100.value0_11.value2_0)
    {
        _S123 = _S103.n_0 + _S121;
    }
    else
    {
        _S123 = (vec3<f32>(0) - _S103.n_0) + _S121;
    }
    (*_S101) = _S123;
    (*_S102) = _S122;
    return;
}

fn _S124( _S125 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S126 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S127 : bool,  _S128 : Axes_0)
{
    var _S129 : s_paramCtx_s_bwdCallableCtx_axes_along_0;
    _S129.value0_10 = (*_S125).primal_0;
    _S129.value1_1 = (*_S126).primal_0;
    _S129.value2_0 = _S127;
    var _S130 : s_bwdCallableCtx_axes_along_0 = s_bwdCallableCtx_axes_along_0( _S129 );
    var _S131 : vec3<f32> = (*_S125).differential_0;
    var _S132 : vec3<f32> = (*_S126).differential_0;
    s_bwdProp_axes_along_0(_S130, &(_S131), &(_S132), _S128);
    (*_S125).differential_0 = _S131;
    (*_S126).differential_0 = _S132;
    return;
}

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

struct s_paramCtx_s_bwdCallableCtx_towards_viewer_0
{
     value0_12 : Axes_0,
     value1_2 : vec3<f32>,
};

struct s_bwdCallableCtx_towards_viewer_0
{
     value0_13 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0,
};

struct Tuple_4
{
     value0_14 : vec3<f32>,
};

fn s_apply_to_local_0( _S133 : Axes_0,  _S134 : vec3<f32>) -> Tuple_4
{
    var _S135 : Tuple_4;
    _S135.value0_14 = vec3<f32>(s_apply_dot_0(_S133.s_0, _S134).value0_6, s_apply_dot_0(_S133.t_0, _S134).value0_6, s_apply_dot_0(_S133.n_0, _S134).value0_6);
    return _S135;
}

struct s_paramCtx_s_bwdCallableCtx_to_local_0
{
     value0_15 : Axes_0,
     value1_3 : vec3<f32>,
};

struct s_bwdCallableCtx_to_local_0
{
     value0_16 : s_paramCtx_s_bwdCallableCtx_to_local_0,
};

fn Axes_x24_syn_dzero_0() -> Axes_0
{
    var result_0 : Axes_0;
    var _S136 : vec3<f32> = vec3<f32>(0.0f);
    result_0.s_0 = _S136;
    result_0.t_0 = _S136;
    result_0.n_0 = _S136;
    return result_0;
}

fn Axes_x24_syn_dadd_0( SLANG_anonymous_0_0 : Axes_0,  SLANG_anonymous_1_0 : Axes_0) -> Axes_0
{
    var result_1 : Axes_0;
    result_1.s_0 = SLANG_anonymous_0_0.s_0 + SLANG_anonymous_1_0.s_0;
    result_1.t_0 = SLANG_anonymous_0_0.t_0 + SLANG_anonymous_1_0.t_0;
    result_1.n_0 = SLANG_anonymous_0_0.n_0 + SLANG_anonymous_1_0.n_0;
    return result_1;
}

fn s_bwdProp_to_local_0( _S137 : s_bwdCallableCtx_to_local_0,  _S138 : ptr<function, Axes_0>,  _S139 : ptr<function, vec3<f32>>,  _S140 : vec3<f32>)
{
    var _S141 : s_bwdCallableCtx_dot_0;
    _S141._S59 = _S137.value0_16.value0_15.s_0;
    _S141._S60 = _S137.value0_16.value1_3;
    var _S142 : s_bwdCallableCtx_dot_0;
    _S142._S59 = _S137.value0_16.value0_15.t_0;
    _S142._S60 = _S137.value0_16.value1_3;
    var _S143 : s_bwdCallableCtx_dot_0;
    _S143._S59 = _S137.value0_16.value0_15.n_0;
    _S143._S60 = _S137.value0_16.value1_3;
    var _S144 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S145 : vec3<f32> = vec3<f32>(0.0f);
    var _S146 : vec3<f32> = _S145;
    var _S147 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S143, &(_S146), &(_S147), _S140[i32(2)]);
    var _S148 : vec3<f32> = _S145;
    var _S149 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S142, &(_S148), &(_S149), _S140[i32(1)]);
    var _S150 : vec3<f32> = _S145;
    var _S151 : vec3<f32> = _S145;
    s_bwdProp_dot_0(_S141, &(_S150), &(_S151), _S140[i32(0)]);
    var _S152 : vec3<f32> = _S147 + _S149 + _S151;
    var _S153 : Axes_0 = _S144;
    _S153.n_0 = _S146;
    _S153.t_0 = _S148;
    _S153.s_0 = _S150;
    (*_S138) = Axes_x24_syn_dadd_0(_S144, _S153);
    (*_S139) = _S152;
    return;
}

fn s_bwdProp_towards_viewer_0( _S154 : s_bwdCallableCtx_towards_viewer_0,  _S155 : ptr<function, Axes_0>,  _S156 : ptr<function, vec3<f32>>,  _S157 : vec3<f32>)
{
    var _S158 : Tuple_4 = s_apply_to_local_0(_S154.value0_13.value0_12, _S154.value0_13.value1_2);
    var _S159 : s_paramCtx_s_bwdCallableCtx_to_local_0;
    _S159.value0_15 = _S154.value0_13.value0_12;
    _S159.value1_3 = _S154.value0_13.value1_2;
    var _S160 : s_bwdCallableCtx_to_local_0 = s_bwdCallableCtx_to_local_0( _S159 );
    var _S161 : f32 = (vec3<f32>(0) - _S158.value0_14).z;
    var _S162 : Tuple_3 = s_apply_abs_0(_S161);
    var _S163 : s_bwdCallableCtx_abs_0;
    _S163._S71 = _S161;
    var _S164 : s_bwdCallableCtx_max_0;
    _S164._S63 = _S162.value0_7;
    _S164._S64 = 9.999999960041972e-13f;
    var _S165 : Axes_0 = Axes_x24_syn_dzero_0();
    var _S166 : f32 = 0.0f;
    var _S167 : f32 = 0.0f;
    s_bwdProp_max_0(_S164, &(_S166), &(_S167), _S157[i32(2)]);
    var _S168 : f32 = 0.0f;
    s_bwdProp_abs_0(_S163, &(_S168), _S166);
    var _S169 : vec3<f32> = (vec3<f32>(0) - vec3<f32>(_S157[i32(0)], _S157[i32(1)], _S168));
    var _S170 : vec3<f32> = vec3<f32>(0.0f);
    var _S171 : Axes_0;
    _S171.s_0 = _S170;
    _S171.t_0 = _S170;
    _S171.n_0 = _S170;
    var _S172 : vec3<f32> = _S170;
    s_bwdProp_to_local_0(_S160, &(_S171), &(_S172), _S169);
    (*_S155) = Axes_x24_syn_dadd_0(_S171, _S165);
    (*_S156) = _S172;
    return;
}

fn _S173( _S174 : ptr<function, DiffPair_Axes_0>,  _S175 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S176 : vec3<f32>)
{
    var _S177 : s_paramCtx_s_bwdCallableCtx_towards_viewer_0;
    _S177.value0_12 = (*_S174).primal_0;
    _S177.value1_2 = (*_S175).primal_0;
    var _S178 : s_bwdCallableCtx_towards_viewer_0 = s_bwdCallableCtx_towards_viewer_0( _S177 );
    var _S179 : Axes_0 = (*_S174).differential_0;
    var _S180 : vec3<f32> = (*_S175).differential_0;
    s_bwdProp_towards_viewer_0(_S178, &(_S179), &(_S180), _S176);
    (*_S174).differential_0 = _S179;
    (*_S175).differential_0 = _S180;
    return;
}

fn side_path_0( number_of_path_0 : u32,  side_0 : u32) -> u32
{
    return launch_0.room_0 / u32(3) + u32(2) * number_of_path_0 + side_0;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S181 : u32 = (*which_1) + u32(3);
    (*which_1) = _S181;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S181 - u32(3)), path_word_0(path_1, _S181 - u32(2)), path_word_0(path_1, _S181 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S182 : u32 = (*which_2) + u32(3);
    (*which_2) = _S182;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S182 - u32(3)), path_word_0(path_2, _S182 - u32(2)), path_word_0(path_2, _S182 - u32(1))))));
}

fn path_vector_2( path_3 : u32,  which_3 : ptr<function, u32>) -> vec3<f32>
{
    var _S183 : u32 = (*which_3) + u32(3);
    (*which_3) = _S183;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_3, _S183 - u32(3)), path_word_0(path_3, _S183 - u32(2)), path_word_0(path_3, _S183 - u32(1))))));
}

fn path_vector_3( path_4 : u32,  which_4 : ptr<function, u32>) -> vec3<f32>
{
    var _S184 : u32 = (*which_4) + u32(3);
    (*which_4) = _S184;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_4, _S184 - u32(3)), path_word_0(path_4, _S184 - u32(2)), path_word_0(path_4, _S184 - u32(1))))));
}

struct Numbers_0
{
     diffuse_reflectance_0 : vec3<f32>,
     specular_reflectance_0 : vec3<f32>,
     eta_0 : vec3<f32>,
     k_0 : vec3<f32>,
     alpha_0 : vec2<f32>,
};

fn no_numbers_0() -> Numbers_0
{
    var numbers_0 : Numbers_0;
    var _S185 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S185;
    numbers_0.eta_0 = _S185;
    numbers_0.specular_reflectance_0 = _S185;
    numbers_0.diffuse_reflectance_0 = _S185;
    numbers_0.alpha_0 = vec2<f32>(0.0f);
    return numbers_0;
}

struct Pulled_0
{
     numbers_1 : Numbers_0,
     axes_0 : Axes_0,
     wi_0 : vec3<f32>,
     position_0 : vec3<f32>,
};

fn nothing_pulled_0() -> Pulled_0
{
    var pulled_0 : Pulled_0;
    pulled_0.numbers_1 = no_numbers_0();
    var _S186 : vec3<f32> = vec3<f32>(0.0f);
    pulled_0.position_0 = _S186;
    pulled_0.wi_0 = _S186;
    pulled_0.axes_0.n_0 = _S186;
    pulled_0.axes_0.t_0 = _S186;
    pulled_0.axes_0.s_0 = _S186;
    return pulled_0;
}

struct Crossed_0
{
     factor_0 : vec3<f32>,
     pulled_1 : Pulled_0,
     goes_on_0 : vec2<bool>,
};

fn nothing_crossed_0( factor_1 : vec3<f32>) -> Crossed_0
{
    var crossed_0 : Crossed_0;
    crossed_0.factor_0 = factor_1;
    crossed_0.goes_on_0 = vec2<bool>(false, false);
    crossed_0.pulled_1 = nothing_pulled_0();
    return crossed_0;
}

fn path_changing_0( path_5 : u32,  which_5 : ptr<function, u32>) -> vec3<f32>
{
    var value_0 : vec3<f32> = path_vector_3(path_5, &((*which_5)));
    return value_0;
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f32,  w_1 : f32) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    place_0.v_0 = v_1;
    place_0.w_0 = w_1;
    place_0.v_rest_0 = 0.0f;
    place_0.w_rest_0 = 0.0f;
    return place_0;
}

fn path_place_0( path_6 : u32,  which_6 : ptr<function, u32>) -> Place_0
{
    var _S187 : u32 = (*which_6) + u32(5);
    (*which_6) = _S187;
    return exact_place_0(path_word_0(path_6, _S187 - u32(5)), (bitcast<f32>((path_word_0(path_6, _S187 - u32(4))))) + (bitcast<f32>((path_word_0(path_6, _S187 - u32(2))))), (bitcast<f32>((path_word_0(path_6, _S187 - u32(3))))) + (bitcast<f32>((path_word_0(path_6, _S187 - u32(1))))));
}

fn path_place_1( path_7 : u32,  which_7 : ptr<function, u32>) -> Place_0
{
    var _S188 : u32 = (*which_7) + u32(5);
    (*which_7) = _S188;
    return exact_place_0(path_word_0(path_7, _S188 - u32(5)), (bitcast<f32>((path_word_0(path_7, _S188 - u32(4))))) + (bitcast<f32>((path_word_0(path_7, _S188 - u32(2))))), (bitcast<f32>((path_word_0(path_7, _S188 - u32(3))))) + (bitcast<f32>((path_word_0(path_7, _S188 - u32(1))))));
}

struct ByRay_0
{
     drift_0 : vec3<f32>,
     direction_0 : vec3<f32>,
};

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_1 : vec3<f32>,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     adjoint_0 : vec3<f32>,
     distance_0 : f32,
     by_ray_0 : ByRay_0,
};

fn load_0( number_of_path_1 : u32) -> Path_0
{
    var at_0 : u32 = u32(1);
    var path_8 : Path_0;
    var _S189 : vec3<f32> = path_vector_0(number_of_path_1, &(at_0));
    path_8.adjoint_0 = _S189;
    path_8.distance_0 = 0.0f;
    var _S190 : vec3<f32> = vec3<f32>(0.0f);
    path_8.by_ray_0.direction_0 = _S190;
    path_8.by_ray_0.drift_0 = _S190;
    var _S191 : vec3<f32> = path_changing_0(number_of_path_1, &(at_0));
    path_8.throughput_0 = _S191;
    var _S192 : vec3<f32> = path_changing_0(number_of_path_1, &(at_0));
    path_8.direction_1 = _S192;
    var _S193 : Place_0 = path_place_0(number_of_path_1, &(at_0));
    path_8.place_1 = _S193;
    path_8.key_0 = vec2<u32>(path_word_0(number_of_path_1, at_0), path_word_0(number_of_path_1, at_0 + u32(1)));
    return path_8;
}

fn depth_of_launch_0() -> u32
{
    return ((launch_0.depth_0) & (u32(65535)));
}

fn kept_at_0( depth_1 : u32) -> u32
{
    return u32(33) + u32(29) * depth_1;
}

fn path_at_vertex_0( number_of_path_2 : u32,  factor_2 : ptr<function, vec3<f32>>) -> Path_0
{
    var path_9 : Path_0 = load_0(number_of_path_2);
    var kept_0 : u32 = kept_at_0(depth_of_launch_0());
    var _S194 : vec3<f32> = path_vector_2(number_of_path_2, &(kept_0));
    (*factor_2) = _S194;
    var _S195 : Place_0 = path_place_1(number_of_path_2, &(kept_0));
    path_9.place_1 = _S195;
    var _S196 : vec3<f32> = path_vector_2(number_of_path_2, &(kept_0));
    path_9.direction_1 = _S196;
    return path_9;
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn word_0( at_1 : u32) -> u32
{
    return scene_0[at_1];
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_2 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_2], primitives_0[at_2 + u32(1)], primitives_0[at_2 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f32>
{
    var at_3 : u32 = u32(9) * place_2.triangle_0;
    var a_2 : vec3<f32> = primitive_vector_0(at_3);
    return a_2 + (primitive_vector_0(at_3 + u32(3)) - a_2) * vec3<f32>((place_2.v_0 + place_2.v_rest_0)) + (primitive_vector_0(at_3 + u32(6)) - a_2) * vec3<f32>((place_2.w_0 + place_2.w_rest_0));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_4 : u32 = u32(9) * triangle_4;
    var a_3 : vec3<f32> = primitive_vector_0(at_4);
    return cross(primitive_vector_0(at_4 + u32(3)) - a_3, primitive_vector_0(at_4 + u32(6)) - a_3);
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn number_0( at_5 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_5])));
}

fn vector_at_0( at_6 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_6), number_0(at_6 + u32(1)), number_0(at_6 + u32(2)));
}

struct Surface_0
{
     place_3 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f32>,
     position_1 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
};

fn surface_at_0( place_4 : Place_0,  direction_2 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_3 = place_4;
    surface_0.shape_0 = shape_of_0(place_4.triangle_0);
    var _S197 : vec3<f32> = position_of_0(place_4);
    surface_0.exact_0 = _S197;
    surface_0.position_1 = _S197;
    var _S198 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S198;
    surface_0.outward_0 = _S198;
    var seen_0 : f32;
    if((dot(_S198, direction_2)) > 0.0f)
    {
        seen_0 = -1.0f;
    }
    else
    {
        seen_0 = 1.0f;
    }
    var normals_0 : u32 = word_0(surface_0.shape_0);
    if(normals_0 != u32(4294967295))
    {
        var record_0 : u32 = triangle_record_0(place_4.triangle_0) + u32(2);
        var a_4 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0));
        var b_1 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(2)));
        if((dot(a_4 + b_1 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_4 + (b_1 - a_4) * vec3<f32>(place_4.v_0) + (c_0 - a_4) * vec3<f32>(place_4.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S199 : u32;
    if(surface_1.is_front_0)
    {
        _S199 = u32(2);
    }
    else
    {
        _S199 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S199);
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S200 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S200;
    lookup_0.by_first_0 = _S200;
    return lookup_0;
}

struct Corners2_0
{
     a_5 : vec2<f32>,
     b_2 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_6 : vec2<f32>,  b_3 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S201 : Corners2_0;
    _S201.a_5 = a_6;
    _S201.b_2 = b_3;
    _S201.c_1 = c_2;
    return _S201;
}

fn precise_0( at_7 : u32) -> f32
{
    return number_0(at_7) + number_0(at_7 + u32(1));
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_8 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_5 = vec2<f32>(precise_0(at_8), precise_0(at_8 + u32(2)));
    uvs_0.b_2 = vec2<f32>(precise_0(at_8 + u32(4)), precise_0(at_8 + u32(6)));
    uvs_0.c_1 = vec2<f32>(precise_0(at_8 + u32(8)), precise_0(at_8 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_9 : u32) -> vec3<f32>
{
    return vec3<f32>(precise_0(at_9), precise_0(at_9 + u32(2)), precise_0(at_9 + u32(4)));
}

fn floor_of_0( x_4 : f32) -> i32
{
    return i32(clamp(floor(x_4), -1.0e+09f, 1.0e+09f));
}

fn wrapped_0( i_0 : i32,  n_1 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_1 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_1;
    }
    else
    {
        period_0 = n_1;
    }
    var inside_0 : i32 = i_0 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_1)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_1 - i32(1) - inside_1;
    }
    return u32(period_0);
}

struct Point_0
{
     value_1 : vec2<f32>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_5 : Point_0) -> Lookup_0
{
    var way_0 : vec2<f32> = place_5.value_1 - floor(place_5.value_1);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S202 : f32 = back_0.x;
    var _S203 : f32 = back_0.y;
    var _S204 : f32 = way_0.x;
    var _S205 : f32 = way_0.y;
    lookup_1.weights_0 = vec4<f32>(_S202 * _S203, _S204 * _S203, _S202 * _S205, _S204 * _S205);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S203, _S203, - _S205, _S205);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S202, - _S204, _S202, _S204);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_5.by_first_1.x) + by_y_0 * vec4<f32>(place_5.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_5.by_second_1.x) + by_y_0 * vec4<f32>(place_5.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_0 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_6 : vec2<f32> = uv_0.value_1 * size_0;
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_6.y), height_0, wrap_1);
        var _S206 : u32 = row_0 * u32(width_0);
        var _S207 : u32 = wrapped_0(floor_of_0(place_6.x), width_0, wrap_1);
        return one_texel_0(_S206 + _S207);
    }
    var centred_0 : Point_0;
    var _S208 : vec2<f32> = place_6 - vec2<f32>(0.5f);
    centred_0.value_1 = _S208;
    centred_0.by_first_1 = uv_0.by_first_1 * size_0;
    centred_0.by_second_1 = uv_0.by_second_1 * size_0;
    var x_5 : i32 = floor_of_0(_S208.x);
    var y_1 : i32 = floor_of_0(_S208.y);
    var _S209 : u32 = wrapped_0(y_1, height_0, wrap_1);
    var _S210 : u32 = u32(width_0);
    var first_1 : u32 = _S209 * _S210;
    var _S211 : u32 = wrapped_0(y_1 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S211 * _S210;
    var left_0 : u32 = wrapped_0(x_5, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_5 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_7 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_7.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_7.v_0 - place_7.w_0, place_7.v_0, place_7.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_7.triangle_0);
    var by_v_0 : vec2<f32> = uvs_1.b_2 - uvs_1.a_5;
    var by_w_0 : vec2<f32> = uvs_1.c_1 - uvs_1.a_5;
    var _S212 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f32> = row_at_0(_S212);
    var to_v_0 : vec3<f32> = row_at_0(_S212 + u32(6));
    var uv_1 : Point_0;
    var _S213 : vec3<f32> = vec3<f32>(uvs_1.a_5 + by_v_0 * vec2<f32>((place_7.v_0 + place_7.v_rest_0)) + by_w_0 * vec2<f32>((place_7.w_0 + place_7.w_rest_0)), 1.0f);
    uv_1.value_1 = vec2<f32>(dot(_S213, to_u_0), dot(_S213, to_v_0));
    var _S214 : vec2<f32> = to_u_0.xy;
    var _S215 : vec2<f32> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(dot(by_v_0, _S214), dot(by_v_0, _S215));
    uv_1.by_second_1 = vec2<f32>(dot(by_w_0, _S214), dot(by_w_0, _S215));
    if(kind_0 == u32(1))
    {
        var _S216 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S216;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_1 - floor(uv_1.value_1);
    var _S217 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S217 = i32(1);
    }
    else
    {
        _S217 = i32(0);
    }
    return one_texel_0(u32(_S217));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S218 : u32 = word_0(texture_2 + u32(1));
    var _S219 : u32 = texture_2 + u32(19);
    var _S220 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_2 : vec3<f32> = _S220;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_10 : u32 = _S219 + _S218 * lookup_3.texels_0[k_1];
        var _S221 : vec3<f32>;
        if(_S218 == u32(1))
        {
            _S221 = vec3<f32>(number_0(at_10));
        }
        else
        {
            _S221 = vector_at_0(at_10);
        }
        var value_3 : vec3<f32> = value_2 + _S221 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_2 = value_3;
    }
    return value_2;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_8 : Place_0) -> vec3<f32>
{
    var _S222 : Lookup_0 = lookup_at_0(texture_4, place_8);
    return looked_up_0(texture_4, _S222, vec2<f32>(0.0f));
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_2 : ptr<function, Numbers_0>,  slot_0 : u32,  value_4 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_2).diffuse_reflectance_0 = value_4;
            break;
        }
    case u32(1):
        {
            (*numbers_2).specular_reflectance_0 = value_4;
            break;
        }
    case u32(2):
        {
            (*numbers_2).eta_0 = value_4;
            break;
        }
    case u32(3):
        {
            (*numbers_2).k_0 = value_4;
            break;
        }
    case u32(4):
        {
            (*numbers_2).alpha_0[i32(0)] = luminance_0(value_4);
            break;
        }
    default :
        {
            (*numbers_2).alpha_0[i32(1)] = luminance_0(value_4);
            break;
        }
    }
    return;
}

struct Lobe_0
{
     record_2 : u32,
     kind_1 : u32,
     distribution_0 : u32,
     numbers_3 : Numbers_0,
};

fn lobe_at_0( record_3 : u32,  place_9 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_2 = record_3;
    var is_black_0 : bool = record_3 == u32(4294967295);
    var _S223 : u32;
    if(is_black_0)
    {
        _S223 = u32(0);
    }
    else
    {
        _S223 = word_0(record_3);
    }
    lobe_0.kind_1 = _S223;
    if(is_black_0)
    {
        _S223 = u32(1);
    }
    else
    {
        _S223 = word_0(record_3 + u32(1));
    }
    lobe_0.distribution_0 = _S223;
    lobe_0.numbers_3 = no_numbers_0();
    if(is_black_0)
    {
        _S223 = u32(0);
    }
    else
    {
        _S223 = word_0(record_3 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S223)
        {
        }
        else
        {
            break;
        }
        var texture_5 : u32 = word_0(record_3 + u32(5) + slot_1);
        if(texture_5 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_1 : vec3<f32> = shown_0(texture_5, place_9);
        var _S224 : vec3<f32> = value_of_0(colour_1);
        var _S225 : Numbers_0 = lobe_0.numbers_3;
        set_slot_0(&(_S225), slot_1, _S224);
        lobe_0.numbers_3 = _S225;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_0;
}

fn tangent_at_0( surface_2 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_2.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_2.place_3.triangle_0) + u32(1)));
    var across_0 : vec3<f32> = cross(tangent_0, surface_2.outward_0);
    var _S226 : vec3<f32>;
    if((dot(across_0, across_0)) > 0.0f)
    {
        _S226 = tangent_0;
    }
    else
    {
        _S226 = vec3<f32>(0.0f);
    }
    return _S226;
}

fn axes_along_0( n_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_1 : Axes_0;
    var _S227 : vec3<f32>;
    if(is_front_1)
    {
        _S227 = n_2;
    }
    else
    {
        _S227 = (vec3<f32>(0) - n_2);
    }
    axes_1.n_0 = _S227;
    var _S228 : vec3<f32> = normalize(tangent_1 - n_2 * vec3<f32>(dot(n_2, tangent_1)));
    axes_1.s_0 = _S228;
    axes_1.t_0 = cross(n_2, _S228);
    return axes_1;
}

fn axes_around_0( n_3 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_2 : Axes_0;
    var _S229 : vec3<f32>;
    if(is_front_2)
    {
        _S229 = n_3;
    }
    else
    {
        _S229 = (vec3<f32>(0) - n_3);
    }
    axes_2.n_0 = _S229;
    var _S230 : f32 = n_3.z;
    var sign_1 : f32;
    if(_S230 < -0.00000999999974738f)
    {
        sign_1 = -1.0f;
    }
    else
    {
        sign_1 = 1.0f;
    }
    var a_7 : f32 = -1.0f / (sign_1 + _S230);
    var _S231 : f32 = n_3.x;
    var _S232 : f32 = n_3.y;
    var b_4 : f32 = _S231 * _S232 * a_7;
    axes_2.s_0 = vec3<f32>(1.0f + sign_1 * _S231 * _S231 * a_7, sign_1 * b_4, - sign_1 * _S231);
    axes_2.t_0 = vec3<f32>(b_4, sign_1 + _S232 * _S232 * a_7, - _S232);
    return axes_2;
}

fn to_local_0( axes_3 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_3.s_0, v_3), dot(axes_3.t_0, v_3), dot(axes_3.n_0, v_3));
}

fn towards_viewer_0( axes_4 : Axes_0,  direction_3 : vec3<f32>) -> vec3<f32>
{
    var wi_1 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_4, direction_3));
    return vec3<f32>(wi_1.x, wi_1.y, max(abs(wi_1.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_3 : Surface_0,
     axes_5 : Axes_0,
     lobe_1 : Lobe_0,
     wi_2 : vec3<f32>,
};

fn vertex_at_0( surface_4 : Surface_0,  material_0 : u32,  direction_4 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_3 = surface_4;
    var _S233 : Lobe_0 = lobe_at_0(material_0, surface_4.place_3);
    vertex_0.lobe_1 = _S233;
    var tangent_2 : vec3<f32> = tangent_at_0(surface_4);
    if((any((tangent_2 != vec3<f32>(0.0f)))))
    {
        vertex_0.axes_5 = axes_along_0(surface_4.outward_0, tangent_2, surface_4.is_front_0);
    }
    else
    {
        vertex_0.axes_5 = axes_around_0(surface_4.outward_0, surface_4.is_front_0);
    }
    vertex_0.wi_2 = towards_viewer_0(vertex_0.axes_5, direction_4);
    return vertex_0;
}

struct VertexMotion_0
{
     velocity_0 : vec3<f32>,
     rotation_0 : vec3<f32>,
};

fn motion_of_0( vertex_1 : Vertex_0) -> VertexMotion_0
{
    var motion_0 : VertexMotion_0;
    var _S234 : vec3<f32> = vec3<f32>(0.0f);
    motion_0.rotation_0 = _S234;
    motion_0.velocity_0 = _S234;
    return motion_0;
}

fn has_smooth_0( lobe_2 : Lobe_0) -> bool
{
    return (lobe_2.kind_1) != u32(1);
}

struct ShadingPoint_0
{
     vertex_2 : Vertex_0,
     whole_0 : VertexMotion_0,
     motion_1 : VertexMotion_0,
     purpose_0 : u32,
     emitter_0 : u32,
     tree_0 : u32,
     has_creases_0 : bool,
     turns_0 : bool,
     planes_0 : u32,
     inside_2 : array<vec3<f32>, i32(8)>,
     front_0 : vec3<f32>,
     front_offset_0 : vec3<f32>,
};

fn shading_point_0( path_10 : Path_0,  at_11 : ptr<function, ShadingPoint_0>) -> bool
{
    var surface_5 : Surface_0 = surface_at_0(path_10.place_1, value_of_0(path_10.direction_1));
    var material_1 : u32 = material_of_0(surface_5);
    var _S235 : Vertex_0 = vertex_at_0(surface_5, material_1, path_10.direction_1);
    (*at_11).vertex_2 = _S235;
    var _S236 : VertexMotion_0 = motion_of_0(_S235);
    (*at_11).motion_1 = _S236;
    (*at_11).whole_0 = _S236;
    (*at_11).planes_0 = u32(0);
    (*at_11).tree_0 = u32(0);
    (*at_11).emitter_0 = u32(0);
    (*at_11).purpose_0 = u32(0);
    (*at_11).turns_0 = false;
    (*at_11).has_creases_0 = false;
    var _S237 : vec3<f32> = vec3<f32>(0.0f);
    (*at_11).front_offset_0 = _S237;
    (*at_11).front_0 = _S237;
    var k_2 : u32 = u32(0);
    for(;;)
    {
        if(k_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        (*at_11).inside_2[k_2] = surface_5.exact_0;
        k_2 = k_2 + u32(1);
    }
    var _S238 : bool;
    if(material_1 != u32(4294967295))
    {
        _S238 = has_smooth_0((*at_11).vertex_2.lobe_1);
    }
    else
    {
        _S238 = false;
    }
    return _S238;
}

fn change_word_0( at_12 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_12];
}

fn turns_1( vertex_3 : Vertex_0) -> bool
{
    return (change_word_0(u32(1))) != u32(0);
}

fn edge_word_0( at_13 : u32) -> u32
{
    return change_word_0(change_word_0(u32(3)) + at_13);
}

fn add_to_sum_0( sum_0 : u32,  derivative_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S239 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * (bitcast<f32>((change_word_0(u32(2)))));
    var size_1 : f32 = abs(scaled_0);
    if(size_1 > 7.73712524553362672e+25f)
    {
        var _S240 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var _S241 : bool = scaled_0 < 0.0f;
    var _S242 : i32;
    if(size_1 >= 1.84467440737095516e+19f)
    {
        _S242 = i32(1);
    }
    else
    {
        _S242 = i32(0);
    }
    var first_2 : u32 = u32(_S242);
    var size_2 : f32;
    if(first_2 == u32(1))
    {
        size_2 = size_1 * 2.32830643653869629e-10f;
    }
    else
    {
        size_2 = size_1;
    }
    var higher_0 : f32 = floor(size_2 * 2.32830643653869629e-10f);
    var lower_0 : f32 = size_2 - higher_0 * 4.294967296e+09f;
    if(first_2 == u32(0))
    {
        size_2 = lower_0 + 0.5f;
    }
    else
    {
        size_2 = lower_0;
    }
    var _S243 : u32 = u32(4) + u32(4) * sum_0;
    var digits_0 : vec2<u32> = vec2<u32>(u32(size_2), u32(higher_0));
    var k_3 : u32 = first_2;
    for(;;)
    {
        var _S244 : bool;
        if(k_3 < u32(4))
        {
            _S244 = (((digits_0.x) | ((digits_0.y)))) != u32(0);
        }
        else
        {
            _S244 = false;
        }
        if(_S244)
        {
        }
        else
        {
            break;
        }
        var _S245 : u32;
        if(_S241)
        {
            _S245 = u32(0) - digits_0.x;
        }
        else
        {
            _S245 = digits_0.x;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S243 + k_3]), _S245);
        var overflows_0 : bool;
        if(_S241)
        {
            overflows_0 = before_0 < (digits_0.x);
        }
        else
        {
            overflows_0 = (before_0 + digits_0.x) < before_0;
        }
        var _S246 : u32 = digits_0.y;
        if(overflows_0)
        {
            _S242 = i32(1);
        }
        else
        {
            _S242 = i32(0);
        }
        var _S247 : vec2<u32> = vec2<u32>(_S246 + u32(_S242), u32(0));
        var _S248 : u32 = k_3 + u32(1);
        digits_0 = _S247;
        k_3 = _S248;
    }
    return;
}

fn add_to_sums_0( first_3 : u32,  derivative_1 : vec3<f32>)
{
    var _S249 : i32;
    if(first_3 == u32(4294967295))
    {
        _S249 = i32(0);
    }
    else
    {
        _S249 = i32(3);
    }
    var _S250 : u32 = u32(_S249);
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < _S250)
        {
        }
        else
        {
            break;
        }
        add_to_sum_0(first_3 + axis_0, derivative_1[axis_0]);
        axis_0 = axis_0 + u32(1);
    }
    return;
}

fn edge_back_0( pulled_2 : ptr<function, Pulled_0>,  vertex_4 : Vertex_0,  directions_turn_0 : bool,  record_4 : u32,  t_1 : f32,  offset_0 : vec3<f32>,  by_velocity_0 : vec3<f32>)
{
    var end_1 : u32 = u32(0);
    for(;;)
    {
        if(end_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S251 : u32 = edge_word_0(record_4 + u32(2) + end_1);
        var _S252 : f32;
        if(end_1 == u32(0))
        {
            _S252 = 1.0f - t_1;
        }
        else
        {
            _S252 = t_1;
        }
        add_to_sums_0(_S251, by_velocity_0 * vec3<f32>(_S252));
        end_1 = end_1 + u32(1);
    }
    (*pulled_2).position_0 = (*pulled_2).position_0 - by_velocity_0;
    if(directions_turn_0)
    {
        (*pulled_2).axes_0.n_0 = (*pulled_2).axes_0.n_0 + cross(vertex_4.axes_5.n_0, cross(offset_0, by_velocity_0));
    }
    return;
}

fn slot_derivative_0( numbers_4 : Numbers_0,  slot_2 : u32) -> vec3<f32>
{
    switch(slot_2)
    {
    case u32(0):
        {
            return numbers_4.diffuse_reflectance_0;
        }
    case u32(1):
        {
            return numbers_4.specular_reflectance_0;
        }
    case u32(2):
        {
            return numbers_4.eta_0;
        }
    case u32(3):
        {
            return numbers_4.k_0;
        }
    case u32(4):
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_4.alpha_0.x);
        }
    default :
        {
            return vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f) * vec3<f32>(numbers_4.alpha_0.y);
        }
    }
}

fn numbers_of_0( texture_6 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_6 + u32(18)));
}

fn add_to_texels_0( texture_7 : u32,  lookup_5 : Lookup_0,  derivative_2 : vec3<f32>)
{
    var first_4 : u32 = numbers_of_0(texture_7);
    var _S253 : u32 = word_0(texture_7 + u32(1));
    var _S254 : u32;
    if(first_4 == u32(4294967295))
    {
        _S254 = u32(0);
    }
    else
    {
        _S254 = lookup_5.count_0;
    }
    var k_4 : u32 = u32(0);
    for(;;)
    {
        if(k_4 < _S254)
        {
        }
        else
        {
            break;
        }
        var own_0 : vec3<f32> = derivative_2 * vec3<f32>(lookup_5.weights_0[k_4]);
        var own_1 : vec3<f32>;
        if(_S253 == u32(1))
        {
            own_1 = vec3<f32>((own_0.x + own_0.y + own_0.z));
        }
        else
        {
            own_1 = own_0;
        }
        var c_3 : u32 = u32(0);
        for(;;)
        {
            if(c_3 < _S253)
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(first_4 + _S253 * lookup_5.texels_0[k_4] + c_3, own_1[c_3]);
            c_3 = c_3 + u32(1);
        }
        k_4 = k_4 + u32(1);
    }
    return;
}

fn lookup_back_0( texture_8 : u32,  lookup_6 : Lookup_0,  derivative_3 : vec3<f32>) -> vec2<f32>
{
    add_to_texels_0(texture_8, lookup_6, derivative_3);
    return vec2<f32>(dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_first_0), derivative_3), dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_second_0), derivative_3));
}

fn numbers_back_0( material_2 : u32,  place_10 : Place_0,  numbers_5 : Numbers_0) -> vec2<f32>
{
    var _S255 : vec2<f32> = vec2<f32>(0.0f);
    var _S256 : u32 = word_0(material_2 + u32(4));
    var slot_3 : u32 = u32(0);
    var by_place_0 : vec2<f32> = _S255;
    for(;;)
    {
        if(slot_3 < _S256)
        {
        }
        else
        {
            break;
        }
        var texture_9 : u32 = word_0(material_2 + u32(5) + slot_3);
        if(texture_9 == u32(4294967295))
        {
            slot_3 = slot_3 + u32(1);
            continue;
        }
        var _S257 : Lookup_0 = lookup_at_0(texture_9, place_10);
        var _S258 : vec2<f32> = lookup_back_0(texture_9, _S257, slot_derivative_0(numbers_5, slot_3));
        by_place_0 = by_place_0 + _S258;
        slot_3 = slot_3 + u32(1);
    }
    return by_place_0;
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

struct AtCorners_0
{
     a_8 : vec3<f32>,
     b_5 : vec3<f32>,
     c_4 : vec3<f32>,
};

fn at_no_corner_0() -> AtCorners_0
{
    var corners_0 : AtCorners_0;
    var _S259 : vec3<f32> = vec3<f32>(0.0f);
    corners_0.c_4 = _S259;
    corners_0.b_5 = _S259;
    corners_0.a_8 = _S259;
    return corners_0;
}

fn unit_back_0( vector_1 : vec3<f32>,  derivative_4 : vec3<f32>,  size_3 : f32) -> vec3<f32>
{
    return (derivative_4 - vector_1 * vec3<f32>(dot(vector_1, derivative_4))) / vec3<f32>(size_3);
}

fn tangent_back_0( points_0 : ptr<function, AtCorners_0>,  triangle_6 : u32,  tangent_3 : vec3<f32>,  by_tangent_0 : vec3<f32>)
{
    var corner_0 : u32 = u32(9) * triangle_6;
    var uvs_2 : Corners2_0 = uvs_of_0(triangle_6);
    var first_5 : vec2<f32> = uvs_2.b_2 - uvs_2.a_5;
    var second_1 : vec2<f32> = uvs_2.c_1 - uvs_2.a_5;
    var _S260 : f32 = second_1.y;
    var _S261 : f32 = first_5.y;
    var scale_0 : f32 = 1.0f / (first_5.x * _S260 - second_1.x * _S261);
    var of_ab_0 : f32 = _S260 * scale_0;
    var of_ac_0 : f32 = - _S261 * scale_0;
    var a_9 : vec3<f32> = primitive_vector_0(corner_0);
    var _S262 : vec3<f32> = vec3<f32>(of_ab_0);
    var _S263 : vec3<f32> = vec3<f32>(of_ac_0);
    var derivative_5 : vec3<f32> = unit_back_0(tangent_3, by_tangent_0, length((primitive_vector_0(corner_0 + u32(3)) - a_9) * _S262 + (primitive_vector_0(corner_0 + u32(6)) - a_9) * _S263));
    (*points_0).a_8 = (*points_0).a_8 - derivative_5 * vec3<f32>((of_ab_0 + of_ac_0));
    (*points_0).b_5 = (*points_0).b_5 + derivative_5 * _S262;
    (*points_0).c_4 = (*points_0).c_4 + derivative_5 * _S263;
    return;
}

fn add_at_place_0( corners_1 : ptr<function, AtCorners_0>,  place_11 : Place_0,  derivative_6 : vec3<f32>)
{
    (*corners_1).a_8 = (*corners_1).a_8 + derivative_6 * vec3<f32>((1.0f - place_11.v_0 - place_11.w_0));
    (*corners_1).b_5 = (*corners_1).b_5 + derivative_6 * vec3<f32>(place_11.v_0);
    (*corners_1).c_4 = (*corners_1).c_4 + derivative_6 * vec3<f32>(place_11.w_0);
    return;
}

fn add_at_place_1( corners_2 : ptr<function, AtCorners_0>,  place_12 : Place_0,  derivative_7 : vec3<f32>)
{
    (*corners_2).a_8 = (*corners_2).a_8 + derivative_7 * vec3<f32>((1.0f - place_12.v_0 - place_12.w_0));
    (*corners_2).b_5 = (*corners_2).b_5 + derivative_7 * vec3<f32>(place_12.v_0);
    (*corners_2).c_4 = (*corners_2).c_4 + derivative_7 * vec3<f32>(place_12.w_0);
    return;
}

fn normals_of_0( triangle_7 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_7)) + u32(1));
}

fn add_to_corners_0( sums_at_0 : u32,  triangle_8 : u32,  corners_3 : AtCorners_0)
{
    var _S264 : u32 = triangle_record_0(triangle_8) + u32(2);
    var _S265 : i32;
    if(sums_at_0 == u32(4294967295))
    {
        _S265 = i32(0);
    }
    else
    {
        _S265 = i32(3);
    }
    var _S266 : u32 = u32(_S265);
    var k_5 : u32 = u32(0);
    for(;;)
    {
        if(k_5 < _S266)
        {
        }
        else
        {
            break;
        }
        var _S267 : u32 = sums_at_0 + u32(3) * word_0(_S264 + k_5);
        var _S268 : vec3<f32>;
        if(k_5 == u32(0))
        {
            _S268 = corners_3.a_8;
        }
        else
        {
            if(k_5 == u32(1))
            {
                _S268 = corners_3.b_5;
            }
            else
            {
                _S268 = corners_3.c_4;
            }
        }
        add_to_sums_0(_S267, _S268);
        k_5 = k_5 + u32(1);
    }
    return;
}

fn place_back_0( points_1 : ptr<function, AtCorners_0>,  place_13 : Place_0,  by_place_1 : vec2<f32>,  by_position_0 : vec3<f32>,  direction_5 : vec3<f32>) -> vec3<f32>
{
    var corner_1 : u32 = u32(9) * place_13.triangle_0;
    var a_10 : vec3<f32> = primitive_vector_0(corner_1);
    var ab_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(3)) - a_10;
    var ac_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(6)) - a_10;
    var across_1 : vec3<f32> = cross(ab_0, ac_0);
    var _S269 : f32 = max(max(abs(across_1.x), abs(across_1.y)), abs(across_1.z));
    var normal_0 : vec3<f32> = across_1 / vec3<f32>(_S269);
    var by_slip_0 : vec3<f32> = by_position_0 + (cross(ac_0, normal_0) * vec3<f32>(by_place_1.x) + cross(normal_0, ab_0) * vec3<f32>(by_place_1.y)) * vec3<f32>((1.0f / (dot(normal_0, normal_0) * _S269)));
    var by_drift_0 : vec3<f32> = by_slip_0 - normal_0 * vec3<f32>((dot(direction_5, by_slip_0) / dot(normal_0, direction_5)));
    add_at_place_1(&((*points_1)), place_13, by_position_0 - by_drift_0);
    return by_drift_0;
}

fn surface_back_0( points_2 : ptr<function, AtCorners_0>,  surface_6 : Surface_0,  by_place_2 : vec2<f32>,  by_position_1 : vec3<f32>,  by_outward_0 : vec3<f32>,  direction_6 : vec3<f32>) -> vec3<f32>
{
    var normals_1 : u32 = word_0(surface_6.shape_0);
    var _S270 : vec2<f32>;
    if(normals_1 == u32(4294967295))
    {
        var corner_2 : u32 = u32(9) * surface_6.place_3.triangle_0;
        var a_11 : vec3<f32> = primitive_vector_0(corner_2);
        var ab_1 : vec3<f32> = primitive_vector_0(corner_2 + u32(3)) - a_11;
        var ac_1 : vec3<f32> = primitive_vector_0(corner_2 + u32(6)) - a_11;
        var derivative_8 : vec3<f32> = unit_back_0(surface_6.outward_0, by_outward_0, length(cross(ab_1, ac_1)));
        var by_ab_0 : vec3<f32> = cross(ac_1, derivative_8);
        var by_ac_0 : vec3<f32> = cross(derivative_8, ab_1);
        (*points_2).a_8 = (*points_2).a_8 - (by_ab_0 + by_ac_0);
        (*points_2).b_5 = (*points_2).b_5 + by_ab_0;
        (*points_2).c_4 = (*points_2).c_4 + by_ac_0;
        _S270 = by_place_2;
    }
    else
    {
        var record_5 : u32 = triangle_record_0(surface_6.place_3.triangle_0) + u32(2);
        var a_12 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_5));
        var ab_2 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_5 + u32(1))) - a_12;
        var ac_2 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_5 + u32(2))) - a_12;
        var derivative_9 : vec3<f32> = unit_back_0(surface_6.outward_0, by_outward_0, length(a_12 + ab_2 * vec3<f32>(surface_6.place_3.v_0) + ac_2 * vec3<f32>(surface_6.place_3.w_0)));
        var of_normals_0 : AtCorners_0 = at_no_corner_0();
        add_at_place_0(&(of_normals_0), surface_6.place_3, derivative_9);
        add_to_corners_0(normals_of_0(surface_6.place_3.triangle_0), surface_6.place_3.triangle_0, of_normals_0);
        _S270 = by_place_2 + vec2<f32>(dot(ab_2, derivative_9), dot(ac_2, derivative_9));
    }
    var _S271 : vec3<f32> = place_back_0(&((*points_2)), surface_6.place_3, _S270, by_position_1, direction_6);
    return _S271;
}

fn points_of_0( triangle_9 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_9)));
}

fn vertex_back_0( pulled_3 : Pulled_0,  vertex_5 : Vertex_0,  material_3 : u32,  direction_7 : vec3<f32>) -> ByRay_0
{
    var by_ray_1 : ByRay_0;
    var _S272 : vec3<f32> = vec3<f32>(0.0f);
    by_ray_1.direction_0 = _S272;
    by_ray_1.drift_0 = _S272;
    var by_place_3 : vec2<f32> = numbers_back_0(material_3, vertex_5.surface_3.place_3, pulled_3.numbers_1);
    if(!is_moving_0())
    {
        return by_ray_1;
    }
    var _S273 : Axes_0 = Axes_x24_syn_dzero_0();
    var towards_0 : DiffPair_Axes_0;
    towards_0.primal_0 = vertex_5.axes_5;
    towards_0.differential_0 = _S273;
    var incoming_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    incoming_0.primal_0 = direction_7;
    incoming_0.differential_0 = _S272;
    _S173(&(towards_0), &(incoming_0), pulled_3.wi_0);
    by_ray_1.direction_0 = incoming_0.differential_0;
    var outward_1 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    outward_1.primal_0 = vertex_5.surface_3.outward_0;
    outward_1.differential_0 = _S272;
    var _S274 : vec3<f32> = tangent_at_0(vertex_5.surface_3);
    var tangent_4 : DiffPair_vectorx3Cfloatx2C3x3E_0;
    tangent_4.primal_0 = _S274;
    tangent_4.differential_0 = _S272;
    var by_axes_0 : Axes_0 = Axes_x24_syn_dadd_0(pulled_3.axes_0, towards_0.differential_0);
    var points_3 : AtCorners_0 = at_no_corner_0();
    if((any((_S274 != _S272))))
    {
        _S124(&(outward_1), &(tangent_4), vertex_5.surface_3.is_front_0, by_axes_0);
        tangent_back_0(&(points_3), vertex_5.surface_3.place_3.triangle_0, tangent_4.primal_0, tangent_4.differential_0);
    }
    else
    {
        _S93(&(outward_1), vertex_5.surface_3.is_front_0, by_axes_0);
    }
    var _S275 : vec3<f32> = surface_back_0(&(points_3), vertex_5.surface_3, by_place_3, pulled_3.position_0, outward_1.differential_0, direction_7);
    by_ray_1.drift_0 = _S275;
    add_to_corners_0(points_of_0(vertex_5.surface_3.place_3.triangle_0), vertex_5.surface_3.place_3.triangle_0, points_3);
    return by_ray_1;
}

fn set_word_0( path_11 : u32,  which_8 : u32,  value_5 : u32)
{
    paths_0[which_8 * launch_0.room_0 + path_11] = value_5;
    return;
}

fn set_vector_0( path_12 : u32,  which_9 : ptr<function, u32>,  value_6 : vec3<f32>)
{
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_12, (*which_9) + axis_1, (bitcast<u32>((value_6[axis_1]))));
        axis_1 = axis_1 + u32(1);
    }
    (*which_9) = (*which_9) + u32(3);
    return;
}

fn add_0( number_of_path_3 : u32,  crossed_1 : Crossed_0,  at_14 : ShadingPoint_0,  direction_8 : vec3<f32>)
{
    var _S276 : vec3<f32> = vec3<f32>(0.0f);
    var _S277 : bool;
    if((all(((crossed_1.pulled_1.position_0) == _S276))))
    {
        _S277 = (all(((crossed_1.pulled_1.axes_0.n_0) == _S276)));
    }
    else
    {
        _S277 = false;
    }
    if(_S277)
    {
        return;
    }
    var by_ray_2 : ByRay_0 = vertex_back_0(crossed_1.pulled_1, at_14.vertex_2, material_of_0(at_14.vertex_2.surface_3), direction_8);
    var _S278 : u32 = kept_at_0(depth_of_launch_0()) + u32(20);
    var kept_1 : u32 = _S278;
    var which_10 : u32 = _S278;
    var drift_1 : vec3<f32> = path_vector_1(number_of_path_3, &(which_10));
    var by_direction_0 : vec3<f32> = path_vector_1(number_of_path_3, &(which_10));
    set_vector_0(number_of_path_3, &(kept_1), drift_1 + by_ray_2.drift_0);
    set_vector_0(number_of_path_3, &(kept_1), by_direction_0 + by_ray_2.direction_0);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S279 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S280 : u32 = u32(2) + zero_0;
        _S279 = _S280;
        if(rounds_0 < _S280)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S279;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S281 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn add_sides_back(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var listed_0 : u32 = launch_0.first_0 + thread_0.x;
    if(listed_0 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_4 : u32 = input_0[listed_0];
    var _S282 : vec3<f32> = vec3<f32>(0.0f);
    var side_1 : u32 = u32(0);
    var sum_1 : vec3<f32> = _S282;
    for(;;)
    {
        if(side_1 < u32(2))
        {
        }
        else
        {
            break;
        }
        var number_1 : u32 = side_path_0(number_of_path_4, side_1);
        var which_11 : u32 = u32(20);
        var weight_0 : vec3<f32> = path_vector_2(number_1, &(which_11));
        which_11 = u32(1);
        if((any((weight_0 != _S282))))
        {
            var _S283 : vec3<f32> = path_vector_2(number_1, &(which_11));
            sum_1 = sum_1 + weight_0 * _S283;
        }
        side_1 = side_1 + u32(1);
    }
    var crossed_2 : Crossed_0 = nothing_crossed_0(_S282);
    var unused_0 : vec3<f32>;
    var path_13 : Path_0 = path_at_vertex_0(number_of_path_4, &(unused_0));
    var at_15 : ShadingPoint_0;
    var _S284 : bool;
    if((all((sum_1 == _S282))))
    {
        _S284 = true;
    }
    else
    {
        var _S285 : bool = shading_point_0(path_13, &(at_15));
        _S284 = !_S285;
    }
    if(_S284)
    {
        return;
    }
    var first_6 : u32 = side_path_0(number_of_path_4, u32(0));
    var kept_2 : u32 = u32(23);
    var _S286 : vec3<f32> = path_vector_2(first_6, &(kept_2));
    var by_velocity_1 : vec3<f32> = _S286 * vec3<f32>((sum_1.x + sum_1.y + sum_1.z));
    var offset_1 : vec3<f32> = path_vector_2(first_6, &(kept_2));
    var _S287 : u32 = kept_2;
    var _S288 : u32 = kept_2 + u32(1);
    kept_2 = _S288;
    var t_2 : f32 = (bitcast<f32>((path_word_0(first_6, _S287))));
    var _S289 : bool = turns_1(at_15.vertex_2);
    var _S290 : u32 = path_word_0(first_6, _S288);
    var _S291 : Pulled_0 = crossed_2.pulled_1;
    edge_back_0(&(_S291), at_15.vertex_2, _S289, _S290, t_2, offset_1, by_velocity_1);
    crossed_2.pulled_1 = _S291;
    add_0(number_of_path_4, crossed_2, at_15, path_13.direction_1);
    check_loops_0();
    return;
}
